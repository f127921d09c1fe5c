/**
 * @file    AppearancePreset.h
 * @brief   looks by name: transfer function, material and lights that go together
 *
 * A preset is a document in JSON, in the form of a scene file's sections:
 *
 * - "name", "description": what people choose by.
 * - "modalities": for which DICOM modalities it is made; empty: for any data.
 * - "cropMargin": leaves out what is further than this from a patient's body, in mm, such as the
 *   scanner's table; below 0 that much of the body too. Default: all is shown.
 * - "transferFunction": "opacity", "color", "gradientOpacity", "opacityUnitDistance" as in a scene,
 *   and "scale", what the first number of each point is: "scalars" (Hounsfield units, for CT),
 *   "percentiles" (0 to 100, of the values above the background), "percentiles-of-all" (of all
 *   values) or "threshold" (0: the threshold found from the histogram; 1: the highest value; -1:
 *   the lowest). Except for scalars, the unit distance is in 400ths of the volume's diagonal.
 * - "material", "lights": as in a scene.
 */

#ifndef AppearancePreset_h
#define AppearancePreset_h

#include "PenumbraLightingModule.h" // For export macro

#include <string>
#include <vector>

namespace penumbra
{

struct AppearancePreset
{
  std::string Name;
  /// In JSON.
  std::string Document;
};

/// The presets that come with Penumbra.
PENUMBRALIGHTING_EXPORT const std::vector<AppearancePreset>& GetAppearancePresets();

/// The materials that come with Penumbra: one document in JSON, by their names.
PENUMBRALIGHTING_EXPORT const std::string& GetNamedMaterials();

}

#endif
