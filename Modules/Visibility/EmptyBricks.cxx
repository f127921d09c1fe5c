#include "EmptyBricks.h"

#include "vtkDataArray.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <limits>

namespace penumbra
{
namespace
{
constexpr int LargestDistance = std::numeric_limits<unsigned char>::max();

struct ValueRange
{
  double Low;
  double High;
};

// The voxels at the corners of a brick's cells, the first and the last along each axis.
struct BrickVoxels
{
  std::array<int, 3> First;
  std::array<int, 3> Last;
};

BrickVoxels GetVoxels(const std::array<int, 3>& brick, const std::array<int, 3>& dimensions)
{
  BrickVoxels voxels;
  for (int axis = 0; axis < 3; ++axis)
  {
    voxels.First[axis] = brick[axis] * EmptyBricks::CellsPerBrick;
    voxels.Last[axis] =
      std::min(voxels.First[axis] + EmptyBricks::CellsPerBrick, dimensions[axis] - 1);
  }
  return voxels;
}

template <typename Scalar>
ValueRange FindRange(
  const Scalar* scalars, const std::array<int, 3>& dimensions, const BrickVoxels& voxels)
{
  Scalar low = std::numeric_limits<Scalar>::max();
  Scalar high = std::numeric_limits<Scalar>::lowest();
  for (int z = voxels.First[2]; z <= voxels.Last[2]; ++z)
  {
    for (int y = voxels.First[1]; y <= voxels.Last[1]; ++y)
    {
      const Scalar* row = scalars + dimensions[0] * (y + dimensions[1] * static_cast<vtkIdType>(z));
      for (int x = voxels.First[0]; x <= voxels.Last[0]; ++x)
      {
        low = std::min(low, row[x]);
        high = std::max(high, row[x]);
      }
    }
  }
  return { static_cast<double>(low), static_cast<double>(high) };
}

ValueRange FindRange(
  vtkDataArray* scalars, const std::array<int, 3>& dimensions, const BrickVoxels& voxels)
{
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(
      return FindRange(static_cast<const VTK_TT*>(scalars->GetVoidPointer(0)), dimensions, voxels));
  }
  return { 0.0, 0.0 };
}
}

//------------------------------------------------------------------------------
EmptyBricks::EmptyBricks(
  vtkDataArray* scalars, const std::array<int, 3>& dimensions, const EmptyRange& isEmpty)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Counts[axis] = std::max(dimensions[axis] - 2, 0) / CellsPerBrick + 1;
  }
  this->Distances.resize(this->GetBrick(0, 0, this->Counts[2]));
  vtkSMPTools::For(0, this->Counts[2],
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int z = static_cast<int>(begin); z < static_cast<int>(end); ++z)
      {
        for (int y = 0; y < this->Counts[1]; ++y)
        {
          for (int x = 0; x < this->Counts[0]; ++x)
          {
            const auto voxels = GetVoxels({ x, y, z }, dimensions);
            const ValueRange range = FindRange(scalars, dimensions, voxels);
            this->Distances[this->GetBrick(x, y, z)] =
              isEmpty(range.Low, range.High) ? LargestDistance : 0;
          }
        }
      }
    });
  this->SpreadDistances();
}

//------------------------------------------------------------------------------
// Two sweeps over half of the 26 neighbours each give the exact Chebyshev distance (Rosenfeld and
// Pfaltz 1968).
void EmptyBricks::SpreadDistances()
{
  for (int z = 0; z < this->Counts[2]; ++z)
  {
    for (int y = 0; y < this->Counts[1]; ++y)
    {
      for (int x = 0; x < this->Counts[0]; ++x)
      {
        this->LowerDistance(x, y, z, true);
      }
    }
  }
  for (int z = this->Counts[2] - 1; z >= 0; --z)
  {
    for (int y = this->Counts[1] - 1; y >= 0; --y)
    {
      for (int x = this->Counts[0] - 1; x >= 0; --x)
      {
        this->LowerDistance(x, y, z, false);
      }
    }
  }
}

//------------------------------------------------------------------------------
void EmptyBricks::LowerDistance(int x, int y, int z, bool forward)
{
  const vtkIdType brick = this->GetBrick(x, y, z);
  int distance = this->Distances[brick];
  for (int neighbour = 0; neighbour < 13 && distance > 1; ++neighbour)
  {
    const int sign = forward ? 1 : -1;
    const std::array<int, 3> at = { x + sign * (neighbour % 3 - 1),
      y + sign * (neighbour / 3 % 3 - 1), z + sign * (neighbour / 9 - 1) };
    const bool inside = std::min({ at[0], at[1], at[2] }) >= 0 && at[0] < this->Counts[0] &&
      at[1] < this->Counts[1] && at[2] < this->Counts[2];
    if (inside)
    {
      distance = std::min(distance, this->Distances[this->GetBrick(at[0], at[1], at[2])] + 1);
    }
  }
  this->Distances[brick] = static_cast<unsigned char>(distance);
}

//------------------------------------------------------------------------------
double EmptyBricks::GetEnd(const std::array<int, 3>& brick, int distance, const ShadowRay& ray)
{
  double end = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
  {
    const double slope = ray.Direction[axis];
    if (slope != 0.0)
    {
      const int border = slope > 0.0 ? brick[axis] + distance : brick[axis] - distance + 1;
      end = std::min(end, (CellsPerBrick * border - ray.Origin[axis]) / slope);
    }
  }
  return end;
}

}
