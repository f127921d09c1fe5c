#include "ScalarBricks.h"

#include "ScalarRange.h"

#include "vtkDataArray.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
// Calls visit(brick, first, last) for each brick, in parallel by layers.
template <typename Visit>
void ForEachBrick(const BrickGrid& grid, const Visit& visit)
{
  vtkSMPTools::For(0, grid.Counts[2],
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int z = static_cast<int>(begin); z < static_cast<int>(end); ++z)
      {
        for (int y = 0; y < grid.Counts[1]; ++y)
        {
          for (int x = 0; x < grid.Counts[0]; ++x)
          {
            const std::array<int, 3> first = { grid.GetFirst(x), grid.GetFirst(y),
              grid.GetFirst(z) };
            const std::array<int, 3> last = { grid.GetLast(x, 0), grid.GetLast(y, 1),
              grid.GetLast(z, 2) };
            visit((z * grid.Counts[1] + y) * grid.Counts[0] + x, first, last);
          }
        }
      }
    });
}

// Calls visit(begin, end) with the voxels of each row of the brick.
template <typename Visit>
void ForEachRow(const BrickGrid& grid, const std::array<int, 3>& first,
  const std::array<int, 3>& last, const Visit& visit)
{
  for (int z = first[2]; z <= last[2]; ++z)
  {
    for (int y = first[1]; y <= last[1]; ++y)
    {
      const vtkIdType row =
        (static_cast<vtkIdType>(z) * grid.Dimensions[1] + y) * grid.Dimensions[0];
      visit(row + first[0], row + last[0] + 1);
    }
  }
}

template <typename Scalar>
void FindRanges(const Scalar* scalars, const ScalarRange& range, ScalarBricks& bricks)
{
  const BrickGrid& grid = bricks.Grid;
  ForEachBrick(grid,
    [&](int brick, const std::array<int, 3>& first, const std::array<int, 3>& last)
    {
      double low = range.High;
      double high = range.Low;
      ForEachRow(grid, first, last,
        [&](vtkIdType voxel, vtkIdType end)
        {
          for (; voxel < end; ++voxel)
          {
            double value = static_cast<double>(scalars[voxel]);
            value = std::isnan(value) ? range.Low : std::clamp(value, range.Low, range.High);
            low = std::min(low, value);
            high = std::max(high, value);
          }
        });
      bricks.Low[brick] = low;
      bricks.High[brick] = high;
    });
}

// Takes along one axis the best of each value and its two neighbours.
template <typename Better>
void WidenAlong(
  int axis, const BrickGrid& grid, std::vector<double>& values, const Better& getBetter)
{
  const std::vector<double> before = values;
  const int stride = axis == 0 ? 1 : axis == 1 ? grid.Counts[0] : grid.Counts[0] * grid.Counts[1];
  vtkSMPTools::For(0, grid.GetNumberOfBricks(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType brick = begin; brick < end; ++brick)
      {
        const vtkIdType at = brick / stride % grid.Counts[axis];
        if (at > 0)
        {
          values[brick] = getBetter(values[brick], before[brick - stride]);
        }
        if (at + 1 < grid.Counts[axis])
        {
          values[brick] = getBetter(values[brick], before[brick + stride]);
        }
      }
    });
}
}

//------------------------------------------------------------------------------
int BrickGrid::GetLast(int brick, int axis) const
{
  return std::min((brick + 1) * this->Edge, this->Dimensions[axis] - 1);
}

//------------------------------------------------------------------------------
BrickGrid MakeBrickGrid(const std::array<int, 3>& dimensions, int edge)
{
  BrickGrid grid;
  grid.Dimensions = dimensions;
  grid.Edge = edge;
  for (int axis = 0; axis < 3; ++axis)
  {
    grid.Counts[axis] = std::max(1, (dimensions[axis] - 2) / edge + 1);
  }
  return grid;
}

//------------------------------------------------------------------------------
ScalarBricks ComputeScalarBricks(
  vtkDataArray* scalars, const BrickGrid& grid, const ScalarRange& range)
{
  ScalarBricks bricks{ grid, std::vector<double>(grid.GetNumberOfBricks()),
    std::vector<double>(grid.GetNumberOfBricks()) };
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(FindRanges(static_cast<VTK_TT*>(scalars->GetVoidPointer(0)), range, bricks));
  }
  return bricks;
}

//------------------------------------------------------------------------------
ScalarBricks WidenToNeighbours(const ScalarBricks& bricks)
{
  ScalarBricks wide = bricks;
  for (int axis = 0; axis < 3; ++axis)
  {
    WidenAlong(axis, wide.Grid, wide.Low, [](double a, double b) { return std::min(a, b); });
    WidenAlong(axis, wide.Grid, wide.High, [](double a, double b) { return std::max(a, b); });
  }
  return wide;
}

//------------------------------------------------------------------------------
std::vector<unsigned char> FindShownBricks(vtkDataArray* mask, const BrickGrid& grid)
{
  std::vector<unsigned char> shown(grid.GetNumberOfBricks(), 0);
  ForEachBrick(grid,
    [&](int brick, const std::array<int, 3>& first, const std::array<int, 3>& last)
    {
      ForEachRow(grid, first, last,
        [&](vtkIdType voxel, vtkIdType end)
        {
          for (; voxel < end && !shown[brick]; ++voxel)
          {
            shown[brick] = mask->GetComponent(voxel, 0) != 0.0 ? 1 : 0;
          }
        });
    });
  return shown;
}

}
