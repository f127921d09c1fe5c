#include "BodyRegion.h"

#include <vtkIdTypeArray.h>
#include <vtkImageConnectivityFilter.h>
#include <vtkImageContinuousErode3D.h>
#include <vtkImageData.h>
#include <vtkImageShrink3D.h>
#include <vtkImageThreshold.h>
#include <vtkIntArray.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
// In Hounsfield units, between air and fat.
constexpr double EdgeOfBody = -300.0;

// The search is done on voxels of about this size in mm: tables are thinner, bodies far thicker.
constexpr double CoarseVoxel = 4.0;

// Of the volume's voxels, the most that a region may keep for cropping to be worth it.
constexpr double MostKept = 0.95;

constexpr double Inside = 255.0;

// The box of the largest connected part in coarse voxels; empty where there is none.
std::optional<std::array<int, 6>> LargestPart(vtkImageData* image, const std::array<int, 3>& shrink)
{
  vtkNew<vtkImageShrink3D> coarse;
  coarse->SetInputData(image);
  coarse->SetShrinkFactors(shrink[0], shrink[1], shrink[2]);
  coarse->AveragingOn();
  vtkNew<vtkImageThreshold> body;
  body->SetInputConnection(coarse->GetOutputPort());
  body->ThresholdByUpper(EdgeOfBody);
  body->SetInValue(Inside);
  body->SetOutValue(0.0);
  body->SetOutputScalarTypeToUnsignedChar();
  vtkNew<vtkImageContinuousErode3D> thick;
  thick->SetInputConnection(body->GetOutputPort());
  thick->SetKernelSize(3, 3, 1);
  vtkNew<vtkImageConnectivityFilter> parts;
  parts->SetInputConnection(thick->GetOutputPort());
  parts->SetScalarRange(Inside, Inside);
  parts->SetExtractionModeToLargestRegion();
  parts->GenerateRegionExtentsOn();
  parts->Update();
  if (parts->GetNumberOfExtractedRegions() < 1)
  {
    return std::nullopt;
  }
  std::array<int, 6> extent;
  parts->GetExtractedRegionExtents()->GetTypedTuple(0, extent.data());
  return extent;
}
}

//------------------------------------------------------------------------------
std::optional<std::array<double, 6>> FindBodyRegion(vtkImageData* image, double margin)
{
  const int* dimensions = image->GetDimensions();
  const double* spacing = image->GetSpacing();
  const double* origin = image->GetOrigin();
  std::array<int, 3> shrink;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int factor = static_cast<int>(std::lround(CoarseVoxel / spacing[axis]));
    shrink[axis] = std::clamp(factor, 1, std::max(1, dimensions[axis] / 3));
  }
  const auto part = LargestPart(image, shrink);
  if (!part)
  {
    return std::nullopt;
  }
  std::array<double, 6> region;
  double kept = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    // What the erosion took away comes back.
    const int eroded = axis < 2 ? 1 : 0;
    const int around = static_cast<int>(std::lround(margin / spacing[axis]));
    const int begin = ((*part)[2 * axis] - eroded) * shrink[axis];
    const int end = ((*part)[2 * axis + 1] + 1 + eroded) * shrink[axis];
    // A body that goes on beyond the volume has no margin there.
    const int first = begin > 0 ? std::max(begin - around, 0) : 0;
    const int last =
      end < dimensions[axis] ? std::min(end + around, dimensions[axis]) - 1 : dimensions[axis] - 1;
    region[2 * axis] = origin[axis] + first * spacing[axis];
    region[2 * axis + 1] = origin[axis] + last * spacing[axis];
    kept *= static_cast<double>(last - first + 1) / dimensions[axis];
  }
  return kept <= MostKept ? std::optional<std::array<double, 6>>(region) : std::nullopt;
}

}
