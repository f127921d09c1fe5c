/**
 * @file    VisibilityTask.h
 * @brief   visibility of several lights at the points of an image, row by row
 */

#ifndef VisibilityTask_h
#define VisibilityTask_h

#include "Medium.h"
#include "OutputGrid.h"
#include "ShadowedLights.h"
#include "VisibleRegion.h"

#include "vtkType.h"

#include <functional>
#include <memory>

namespace penumbra
{

struct VisibilityTask
{
  VolumeFrames Frames;
  VisibleRegion Region;
  std::unique_ptr<const Medium> Matter;
  std::vector<ShadowedLight> Lights;
  std::array<int, 3> NumberOfPoints{}; ///< of the whole image
  std::array<int, 6> Points{};         ///< what to compute of it, counted from its first point
  /// One for each light, and how far apart its values of one point and the next are.
  std::vector<float*> Values;
  vtkIdType Stride = 1;

  /// Told the part that is done, 0 to 1, by the calling thread. False ends the work.
  using Progress = std::function<bool(double)>;

  /// The values do not depend on the number of threads. False where it was ended.
  bool Run(const Progress& progress) const;

private:
  void ComputeRow(vtkIdType row) const;
  double ComputeVisibility(const ShadowedLight& light, const Vector3& point) const;
};

}

#endif
