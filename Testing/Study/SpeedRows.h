/**
 * @file SpeedRows.h
 * @brief Rows of the speed study with known figures.
 */
#ifndef SpeedRows_h
#define SpeedRows_h

#include "SpeedRow.h"

namespace penumbra
{
/// A scene with bounds in its own size, of which a frame takes this many unlit frames of the stock
/// mapper, of a second each.
inline SpeedRow Row(const std::string& scene, const std::string& variant, double relative)
{
  SpeedRow row;
  row.Scene = scene;
  row.HasBounds = true;
  row.Edge = 256;
  row.Voxels = 256 * 256 * 256;
  row.Variant = variant;
  row.Technique = "none";
  row.CpuSeconds = relative;
  row.Seconds = 0.5 * relative;
  row.Relative = relative;
  return row;
}

/// One with a shadow from a cache, this far off.
inline SpeedRow Cached(
  const std::string& scene, const std::string& technique, double relative, double rmse)
{
  SpeedRow row = Row(scene, technique, relative);
  row.Technique = technique;
  row.Error = PictureError{ rmse, 0.1, 2.0, 9.0, 0.99 };
  row.LightEdit = 2.0 * relative;
  row.OpacityEdit = 3.0 * relative;
  return row;
}
}

#endif
