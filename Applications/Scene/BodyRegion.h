/**
 * @file    BodyRegion.h
 * @brief   where in a CT the patient is
 */

#ifndef BodyRegion_h
#define BodyRegion_h

#include <array>
#include <optional>

class vtkImageData;

namespace penumbra
{

/**
 * The smallest box around the patient's body and `margin` mm around it, as cropping of a scene's
 * volume. The body is the largest connected part denser than fat's edge (-300 HU), after thin
 * things such as a table's shell are gone. Nothing where the box would not leave out much.
 */
std::optional<std::array<double, 6>> FindBodyRegion(vtkImageData* image, double margin);

}

#endif
