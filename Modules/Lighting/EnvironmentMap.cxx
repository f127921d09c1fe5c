#include "EnvironmentMap.h"

#include "EnvironmentParts.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <cmath>

namespace penumbra
{
namespace
{
constexpr int NumberOfFaces = 6;

template <typename Scalar>
void CopyPixels(const Scalar* scalars, int components, double scale, EnvironmentImage& copy)
{
  const bool grey = components < 3;
  copy.Pixels.reserve(static_cast<std::size_t>(copy.Width) * copy.Height * 3);
  for (int row = copy.Height - 1; row >= 0; --row)
  {
    const Scalar* pixel = scalars + static_cast<std::size_t>(row) * copy.Width * components;
    for (int column = 0; column < copy.Width; ++column, pixel += components)
    {
      for (int channel = 0; channel < 3; ++channel)
      {
        copy.Pixels.push_back(static_cast<float>(pixel[grey ? 0 : channel] / scale));
      }
    }
  }
}

/// False where the map has no meaning for such scalars.
bool CopyPixels(vtkDataArray* array, EnvironmentImage& copy)
{
  const void* scalars = array->GetVoidPointer(0);
  const int components = array->GetNumberOfComponents();
  switch (array->GetDataType())
  {
    case VTK_UNSIGNED_CHAR:
      CopyPixels(static_cast<const unsigned char*>(scalars), components, 255.0, copy);
      return true;
    case VTK_UNSIGNED_SHORT:
      CopyPixels(static_cast<const unsigned short*>(scalars), components, 65535.0, copy);
      return true;
    case VTK_FLOAT:
      CopyPixels(static_cast<const float*>(scalars), components, 1.0, copy);
      return true;
    case VTK_DOUBLE:
      CopyPixels(static_cast<const double*>(scalars), components, 1.0, copy);
      return true;
    default:
      return false;
  }
}

std::string DescribeSize(const EnvironmentImage& image)
{
  return std::to_string(image.Width) + " x " + std::to_string(image.Height);
}

/// Why the values are no radiance; empty where they are.
std::string FindFault(const std::vector<float>& values)
{
  for (const float value : values)
  {
    if (std::isnan(value))
    {
      return "has values that are not a number";
    }
    if (std::isinf(value))
    {
      return "has values that are infinite or too large";
    }
    if (value < 0.0f)
    {
      return "has negative values";
    }
  }
  return "";
}

/// Fills the copy; returns why the image cannot be part of a map, empty where it can.
std::string CopyImage(vtkImageData* image, EnvironmentImage& copy)
{
  if (!image)
  {
    return "is missing";
  }
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (!scalars || image->GetNumberOfPoints() == 0 ||
    scalars->GetNumberOfTuples() < image->GetNumberOfPoints())
  {
    return "is empty";
  }
  int dimensions[3];
  image->GetDimensions(dimensions);
  if (dimensions[2] != 1)
  {
    return "is not two-dimensional";
  }
  const int components = scalars->GetNumberOfComponents();
  if (components < 1 || components > 4)
  {
    return "has " + std::to_string(components) + " components per pixel, not 1 to 4";
  }
  copy.Width = dimensions[0];
  copy.Height = dimensions[1];
  if (!CopyPixels(scalars, copy))
  {
    return std::string("has values of type ") + scalars->GetDataTypeAsString() +
      ", not 8 or 16 bits unsigned or floating-point";
  }
  return FindFault(copy.Pixels);
}

/// Why the image cannot be a face beside the first; empty where it can.
std::string FindMisfit(const EnvironmentImage& face, const EnvironmentImage& first)
{
  if (face.Width != face.Height)
  {
    return "is not square (" + DescribeSize(face) + ")";
  }
  if (face.Width != first.Width)
  {
    return "is not of the first one's size (" + DescribeSize(face) + ", not " +
      DescribeSize(first) + ")";
  }
  return "";
}
}

//------------------------------------------------------------------------------
std::optional<EnvironmentMap> MakeEnvironmentMap(
  const std::vector<vtkImageData*>& images, std::string& reason)
{
  const std::size_t count = images.size();
  const bool cube = count == NumberOfFaces;
  if (!cube && count != 1)
  {
    reason = "there are " + std::to_string(count) + " images, not one or six";
    return std::nullopt;
  }
  EnvironmentMap map;
  map.Images.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    std::string fault = CopyImage(images[i], map.Images[i]);
    if (cube && fault.empty())
    {
      fault = FindMisfit(map.Images[i], map.Images[0]);
    }
    if (!fault.empty())
    {
      reason = (cube ? "image " + std::to_string(i + 1) + " of 6 " : "the image ") + fault;
      return std::nullopt;
    }
  }
  return map;
}

//------------------------------------------------------------------------------
std::array<double, 3> MeanRadiance(const EnvironmentMap& map)
{
  std::array<double, 3> sum{};
  double whole = 0.0;
  VisitParts(map, WholePixels,
    [&](double solidAngle, const SphericalAngles&, const float* radiance)
    {
      whole += solidAngle;
      for (int channel = 0; channel < 3; ++channel)
      {
        sum[channel] += solidAngle * radiance[channel];
      }
    });
  return { sum[0] / whole, sum[1] / whole, sum[2] / whole };
}

}
