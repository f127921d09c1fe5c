#include "StudyVolumes.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>

#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>
#include <vtkXMLImageDataWriter.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace penumbra
{
namespace
{
using Vector = std::array<double, 3>;

double Stretched(int index, int count)
{
  return count > 1 ? 2.0 * index / (count - 1) - 1.0 : 0.0;
}

// 1 inside of a surface, 0 outside, over a border of the given width; distance is positive inside.
double SoftStep(double distance, double width)
{
  return std::clamp(0.5 + distance / width, 0.0, 1.0);
}

struct Branch
{
  Vector From;
  Vector To;
  double Radius;
};

double DistanceTo(const Branch& branch, const Vector& point)
{
  Vector along;
  Vector offset;
  double length2 = 0.0;
  double projection = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    along[axis] = branch.To[axis] - branch.From[axis];
    offset[axis] = point[axis] - branch.From[axis];
    length2 += along[axis] * along[axis];
    projection += along[axis] * offset[axis];
  }
  const double part = std::clamp(projection / length2, 0.0, 1.0);
  return std::hypot(
    offset[0] - part * along[0], offset[1] - part * along[1], offset[2] - part * along[2]);
}

// Each fork turns by a quarter about the branch before it.
void Grow(const Vector& from, double heading, double lean, double length, double radius, int forks,
  std::vector<Branch>& branches)
{
  const Vector to = { from[0] + length * std::sin(lean) * std::cos(heading),
    from[1] + length * std::sin(lean) * std::sin(heading), from[2] + length * std::cos(lean) };
  branches.push_back({ from, to, radius });
  if (forks > 0)
  {
    Grow(to, heading + 0.9, lean + 0.45, 0.74 * length, 0.68 * radius, forks - 1, branches);
    Grow(to, heading + 2.8, lean + 0.25, 0.78 * length, 0.72 * radius, forks - 1, branches);
    Grow(to, heading - 1.7, 0.6 * lean + 0.35, 0.70 * length, 0.62 * radius, forks - 1, branches);
  }
}

std::vector<Branch> GrowTree()
{
  std::vector<Branch> branches;
  Grow({ 0.0, 0.0, -0.95 }, 0.3, 0.08, 0.52, 0.12, 4, branches);
  return branches;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MakeStudyVolume(const StudyGrid& grid, const StudyField& field)
{
  auto volume = vtkSmartPointer<vtkImageData>::New();
  volume->SetDimensions(grid.Dimensions.data());
  volume->SetSpacing(grid.Spacing.data());
  volume->SetOrigin(grid.Origin.data());
  volume->AllocateScalars(grid.ScalarType, 1);
  vtkDataArray* scalars = volume->GetPointData()->GetScalars();
  const bool whole = grid.ScalarType != VTK_FLOAT && grid.ScalarType != VTK_DOUBLE;
  const int columns = grid.Dimensions[0];
  const int rows = grid.Dimensions[1];
  const int slices = grid.Dimensions[2];
  const auto fillSlices = [&](vtkIdType begin, vtkIdType end)
  {
    vtkIdType voxel = begin * columns * rows;
    for (vtkIdType k = begin; k < end; ++k)
    {
      for (int j = 0; j < rows; ++j)
      {
        for (int i = 0; i < columns; ++i, ++voxel)
        {
          const double value = field(
            Stretched(i, columns), Stretched(j, rows), Stretched(static_cast<int>(k), slices));
          scalars->SetComponent(voxel, 0,
            whole
              ? std::clamp(std::round(value), scalars->GetDataTypeMin(), scalars->GetDataTypeMax())
              : value);
        }
      }
    }
  };
  vtkSMPTools::For(0, slices, fillSlices);
  return volume;
}

//------------------------------------------------------------------------------
void WriteStudyVolume(vtkImageData* volume, const std::filesystem::path& file)
{
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetFileName(file.u8string().c_str());
  writer->SetCompressorTypeToNone();
  writer->EncodeAppendedDataOff();
  writer->SetInputData(volume);
  writer->Write();
  if (!std::filesystem::exists(file))
  {
    throw std::runtime_error(file.u8string() + " cannot be written");
  }
}

//------------------------------------------------------------------------------
double TwoBalls(double x, double y, double z)
{
  const double large = SoftStep(0.6 - std::hypot(x, y, z + 0.15), 0.15);
  const double small = SoftStep(0.24 - std::hypot(x - 0.35, y - 0.25, z - 0.5), 0.15);
  return 255.0 * std::max(large, small);
}

//------------------------------------------------------------------------------
double Shells(double x, double y, double z)
{
  const double radius = std::hypot(x, y, z);
  constexpr double period = 0.35;
  constexpr double pi = 3.14159265358979323846;
  return radius < 1.0 ? 127.5 * (1.0 + std::cos(2.0 * pi * radius / period)) : 0.0;
}

//------------------------------------------------------------------------------
double FloorAndBar(double x, double y, double z)
{
  const double floor = SoftStep(-0.6 - z, 0.1);
  const double bar = std::min({ SoftStep(0.15 - std::abs(x), 0.1), SoftStep(0.7 - std::abs(y), 0.1),
    SoftStep(0.12 - std::abs(z - 0.2), 0.1) });
  return 255.0 * std::max(floor, bar);
}

//------------------------------------------------------------------------------
double Tree(double x, double y, double z)
{
  static const std::vector<Branch> branches = GrowTree();
  double most = 0.0;
  for (const Branch& branch : branches)
  {
    most = std::max(most, SoftStep(branch.Radius - DistanceTo(branch, { x, y, z }), 0.06));
  }
  const double pot =
    std::min(SoftStep(0.45 - std::hypot(x, y), 0.05), SoftStep(0.08 - std::abs(z + 0.92), 0.05));
  return std::max(180.0 * most, 255.0 * pot);
}

//------------------------------------------------------------------------------
double Casting(double x, double y, double z)
{
  const double block = std::min({ SoftStep(0.8 - std::abs(x), 0.05),
    SoftStep(0.6 - std::abs(y), 0.05), SoftStep(0.5 - std::abs(z), 0.05) });
  const double bores = std::max(
    SoftStep(0.22 - std::hypot(x + 0.4, y), 0.05), SoftStep(0.22 - std::hypot(x - 0.4, y), 0.05));
  const double channel = SoftStep(0.12 - std::hypot(y, z + 0.2), 0.05);
  const double sleeves = std::max(SoftStep(0.04 - std::abs(std::hypot(x + 0.4, y) - 0.22), 0.04),
    SoftStep(0.04 - std::abs(std::hypot(x - 0.4, y) - 0.22), 0.04));
  const double matter = std::min(block, 1.0 - std::max(bores, channel));
  return std::max(140.0 * matter, 240.0 * std::min(sleeves, SoftStep(0.62 - std::abs(z), 0.05)));
}

//------------------------------------------------------------------------------
double Haze(double x, double y, double z)
{
  return 255.0 * std::exp(-1.5 * (z + 1.0)) * (0.75 + 0.25 * std::sin(3.0 * x) * std::cos(2.0 * y));
}

}
