#include "VisibilityTask.h"

#include "vtkSMPTools.h"

#include <algorithm>

namespace penumbra
{
namespace
{
// Threads wait for each other after every batch, to tell the progress and to hear of an end.
constexpr vtkIdType LargestBatch = 16384; // points
constexpr vtkIdType FewestBatches = 64;

vtkIdType ChooseRowsPerBatch(vtkIdType rows, vtkIdType pointsPerRow)
{
  const vtkIdType most = std::max<vtkIdType>(LargestBatch / pointsPerRow, 1);
  return std::clamp<vtkIdType>(rows / FewestBatches, 1, most);
}
}

//------------------------------------------------------------------------------
bool VisibilityTask::Run(const Progress& progress) const
{
  const vtkIdType rowsPerSlice = this->Points[3] - this->Points[2] + 1;
  const vtkIdType rows = rowsPerSlice * (this->Points[5] - this->Points[4] + 1);
  const vtkIdType batch = ChooseRowsPerBatch(rows, this->Points[1] - this->Points[0] + 1);
  for (vtkIdType first = 0; first < rows; first += batch)
  {
    if (!progress(static_cast<double>(first) / rows))
    {
      return false;
    }
    vtkSMPTools::For(first, std::min(first + batch, rows), 1,
      [this](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType row = begin; row < end; ++row)
        {
          this->ComputeRow(row);
        }
      });
  }
  return progress(1.0);
}

//------------------------------------------------------------------------------
void VisibilityTask::ComputeRow(vtkIdType row) const
{
  const int rowsPerSlice = this->Points[3] - this->Points[2] + 1;
  const int pointsPerRow = this->Points[1] - this->Points[0] + 1;
  const auto getIndex = [this](int axis, vtkIdType point)
  {
    return GetIndexOfPoint(static_cast<int>(this->Points[2 * axis] + point),
      this->NumberOfPoints[axis], this->Frames.Dimensions[axis]);
  };
  Vector3 point = { 0.0, getIndex(1, row % rowsPerSlice), getIndex(2, row / rowsPerSlice) };
  for (int x = 0; x < pointsPerRow; ++x)
  {
    point[0] = getIndex(0, x);
    const vtkIdType at = this->Stride * (row * pointsPerRow + x);
    for (std::size_t light = 0; light < this->Lights.size(); ++light)
    {
      this->Values[light][at] =
        static_cast<float>(this->ComputeVisibility(this->Lights[light], point));
    }
  }
}

//------------------------------------------------------------------------------
double VisibilityTask::ComputeVisibility(const ShadowedLight& light, const Vector3& point) const
{
  ShadowRay ray = light.MakeRay(this->Frames, point);
  if (!this->Region.Intersect(ray))
  {
    return 1.0;
  }
  return light.GetVisibility(this->Matter->ComputeOpticalDepth(ray, light.LargestDepth));
}

}
