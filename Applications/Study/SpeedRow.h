/**
 * @file    SpeedRow.h
 * @brief   one line of the speed study: what a way of drawing a scene costs
 */

#ifndef SpeedRow_h
#define SpeedRow_h

#include "StudyPicture.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace penumbra
{

/// Times are processor seconds of all threads, medians, but for Seconds.
struct SpeedRow
{
  std::string Scene;
  bool HasBounds = false;
  /// The volume in its own size, not resampled.
  bool IsOwnSize = true;
  /// Voxels along the longest edge, and in all.
  int Edge = 0;
  std::int64_t Voxels = 0;
  /// Pixels along each edge.
  int Image = 512;
  int Lights = 1;

  std::string Variant;
  /// What drew the shadows in the end: "rays", "volume", ..., "none".
  std::string Technique;
  /// Of a cache, relative to the volume's.
  double Resolution = 1.0;

  double CpuSeconds = 0.0;
  /// By the clock.
  double Seconds = 0.0;
  /// CpuSeconds as a multiple of the stock mapper's unlit frame of the same scene and sizes.
  double Relative = 0.0;
  /// The frame with all that is done once, and the full frame after a light has moved or the
  /// opacity function has changed.
  ///@{
  double First = 0.0;
  std::optional<double> LightEdit;
  std::optional<double> OpacityEdit;
  ///@}

  /// Against the variant's truth.
  std::optional<PictureError> Error;
  /// Part of the pixels that skipping empty space changes by more than a grey level.
  std::optional<double> ChangedBySkipping;
  /// The most bytes that penumbra-render holds for it, at 16 x 16 pixels but for auto.
  std::optional<std::uint64_t> PeakMemory;
  /// What the renderer counts of the frame, by name.
  std::map<std::string, double> Counts;

  bool IsPlain() const { return this->IsOwnSize && this->Image == 512 && this->Lights == 1; }
  /// A time in frames of the stock mapper, unlit.
  double InStockFrames(double cpuSeconds) const
  {
    return this->CpuSeconds > 0.0 ? this->Relative * cpuSeconds / this->CpuSeconds : 0.0;
  }
};

void to_json(nlohmann::json& json, const SpeedRow& row);
void from_json(const nlohmann::json& json, SpeedRow& row);

}

#endif
