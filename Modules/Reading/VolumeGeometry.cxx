#include "VolumeGeometry.h"

#include "VolumeReadingError.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace penumbra
{

namespace
{

// Headers often print directions with four digits, which shears axes by about 1e-4. Ten times that
// is let pass: over 256 voxels it moves a voxel by a quarter of a voxel.
constexpr double ShearTolerance = 1e-3;

// Rounding in double precision; matrices this close to orthonormal are kept to the last bit.
constexpr double RoundingTolerance = 1e-12;

// The volume of the parallelepiped of the three directions of unit length, below which they are
// taken to lie in a plane.
constexpr double SingularTolerance = 1e-6;

template <typename Values>
std::string Listed(const Values& values)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  const char* separator = "";
  for (const auto value : values)
  {
    text << separator << value;
    separator = " ";
  }
  return text.str();
}

template <typename Values>
bool AllFinite(const Values& values)
{
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

Vector3 Column(const std::array<double, 9>& matrix, int column)
{
  return { matrix[column], matrix[3 + column], matrix[6 + column] };
}

double LargestCosine(const std::array<double, 9>& direction)
{
  double largest = 0.0;
  for (int first = 0; first < 3; ++first)
  {
    const Vector3 a = Column(direction, first);
    const Vector3 b = Column(direction, (first + 1) % 3);
    largest = std::max(largest, std::abs(vtkMath::Dot(a.data(), b.data())));
  }
  return largest;
}

}

void SetSteps(VolumeGeometry& geometry, const std::array<Vector3, 3>& steps)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const Vector3& step = steps[axis];
    const double length = std::hypot(step[0], step[1], step[2]);
    if (!std::isfinite(length) || length <= 0.0)
    {
      throw VolumeReadingError("index axis " + std::to_string(axis + 1) + " has the step (" +
        Listed(step) + "); it must be finite and longer than 0");
    }
    geometry.spacing[axis] = length;
    for (int row = 0; row < 3; ++row)
    {
      geometry.direction[3 * row + axis] = step[row] / length;
    }
  }
  const double shear = LargestCosine(geometry.direction);
  if (shear > ShearTolerance)
  {
    throw VolumeReadingError("its axes are sheared (directions, row by row: " +
      Listed(geometry.direction) + "); they must be perpendicular to each other");
  }
  if (shear > RoundingTolerance)
  {
    double sheared[3][3];
    double orthonormal[3][3];
    std::copy(geometry.direction.begin(), geometry.direction.end(), &sheared[0][0]);
    vtkMath::Orthogonalize3x3(sheared, orthonormal);
    std::copy(&orthonormal[0][0], &orthonormal[0][0] + 9, geometry.direction.begin());
  }
}

void CheckGeometry(const VolumeGeometry& geometry)
{
  NumberOfVoxels(geometry, 1);
  for (const double spacing : geometry.spacing)
  {
    if (!std::isfinite(spacing) || spacing <= 0.0)
    {
      throw VolumeReadingError("its spacing is " + Listed(geometry.spacing) +
        "; three finite numbers larger than 0 are needed");
    }
  }
  if (!AllFinite(geometry.origin))
  {
    throw VolumeReadingError(
      "its origin is " + Listed(geometry.origin) + "; three finite numbers are needed");
  }
  double lengths = 1.0;
  double matrix[3][3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const Vector3 column = Column(geometry.direction, axis);
    lengths *= std::hypot(column[0], column[1], column[2]);
    std::copy(column.begin(), column.end(), matrix[axis]);
  }
  // Written so that NaN fails as well.
  if (!(std::abs(vtkMath::Determinant3x3(matrix)) > SingularTolerance * lengths))
  {
    throw VolumeReadingError("its direction, row by row, is " + Listed(geometry.direction) +
      "; an invertible matrix of nine finite numbers is needed");
  }
}

std::uint64_t NumberOfVoxels(const VolumeGeometry& geometry, std::uint64_t scalarSize)
{
  std::uint64_t count = 1;
  const std::uint64_t limit = static_cast<std::uint64_t>(std::numeric_limits<vtkIdType>::max());
  for (const std::int64_t size : geometry.dimensions)
  {
    if (size < 1 || size > std::numeric_limits<int>::max())
    {
      throw VolumeReadingError("its dimensions are " + Listed(geometry.dimensions) +
        "; each must be from 1 to " + std::to_string(std::numeric_limits<int>::max()));
    }
    if (count > limit / scalarSize / static_cast<std::uint64_t>(size))
    {
      throw VolumeReadingError(
        "its dimensions are " + Listed(geometry.dimensions) + ", more voxels than memory can hold");
    }
    count *= static_cast<std::uint64_t>(size);
  }
  return count;
}

void ApplyGeometry(const VolumeGeometry& geometry, vtkImageData* image)
{
  image->SetDimensions(static_cast<int>(geometry.dimensions[0]),
    static_cast<int>(geometry.dimensions[1]), static_cast<int>(geometry.dimensions[2]));
  image->SetSpacing(geometry.spacing.data());
  image->SetOrigin(geometry.origin.data());
  image->SetDirectionMatrix(geometry.direction.data());
}

}
