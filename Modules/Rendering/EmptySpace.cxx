#include "EmptySpace.h"

#include "VisibleScalars.h"

#include "vtkSMPTools.h"

#include <algorithm>

namespace penumbra
{
namespace
{
constexpr int LargestEdge = 255;

// Which of the three intervals that the planes make on an axis a brick reaches.
std::array<bool, 3> FindIntervals(double first, double last, double low, double high)
{
  return { first <= low, last >= low && first <= high, last >= high };
}

bool IsShown(const CroppedRegions& regions, const BrickGrid& grid, const std::array<int, 3>& brick)
{
  std::array<std::array<bool, 3>, 3> reached;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double beyond = grid.Dimensions[axis] == 1 ? 0.5 : 0.0;
    reached[axis] = FindIntervals(grid.GetFirst(brick[axis]) - beyond,
      grid.GetLast(brick[axis], axis) + beyond, regions.Low[axis], regions.High[axis]);
  }
  for (int region = 0; region < 27; ++region)
  {
    const bool isReached =
      reached[0][region % 3] && reached[1][region / 3 % 3] && reached[2][region / 9];
    if (isReached && (regions.Flags >> region & 1) != 0)
    {
      return true;
    }
  }
  return false;
}

// Of the empty cubes that begin at a brick and extend ahead of it the largest is one larger than
// the least of those that begin at its seven neighbours ahead.
void FindCubes(const std::vector<unsigned char>& occupied, const BrickGrid& grid,
  const std::array<int, 3>& ahead, unsigned char* cubes)
{
  const auto& counts = grid.Counts;
  const std::array<int, 3> strides = { 1, counts[0], counts[0] * counts[1] };
  std::array<int, 3> at;
  for (int k = counts[2] - 1; k >= 0; --k)
  {
    at[2] = ahead[2] > 0 ? k : counts[2] - 1 - k;
    for (int j = counts[1] - 1; j >= 0; --j)
    {
      at[1] = ahead[1] > 0 ? j : counts[1] - 1 - j;
      for (int i = counts[0] - 1; i >= 0; --i)
      {
        at[0] = ahead[0] > 0 ? i : counts[0] - 1 - i;
        const int brick = at[0] + at[1] * strides[1] + at[2] * strides[2];
        int least = occupied[brick] ? -1 : LargestEdge - 1;
        const bool last[] = { i + 1 == counts[0], j + 1 == counts[1], k + 1 == counts[2] };
        for (int neighbour = 1; neighbour < 8 && least > 0; ++neighbour)
        {
          const bool x = neighbour & 1, y = neighbour & 2, z = neighbour & 4;
          const bool outside = (x && last[0]) || (y && last[1]) || (z && last[2]);
          if (!outside)
          {
            least = std::min<int>(least,
              cubes[brick + x * ahead[0] + y * ahead[1] * strides[1] + z * ahead[2] * strides[2]]);
          }
        }
        cubes[brick] = static_cast<unsigned char>(least + 1);
      }
    }
  }
}
}

//------------------------------------------------------------------------------
std::vector<unsigned char> FindOccupiedBricks(
  const ScalarBricks& bricks, const VisibleScalars& visible, const BrickVisibility& visibility)
{
  const BrickGrid& grid = bricks.Grid;
  const bool gradients = visibility.LeastGradient > 0.0;
  const ScalarBricks wide = gradients ? WidenToNeighbours(bricks) : ScalarBricks();
  std::vector<unsigned char> occupied(grid.GetNumberOfBricks());
  vtkSMPTools::For(0, grid.GetNumberOfBricks(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType brick = begin; brick < end; ++brick)
      {
        bool isOccupied = visible.AnyBetween(bricks.Low[brick], bricks.High[brick]);
        isOccupied = isOccupied &&
          (!gradients ||
            visibility.GradientBound * (wide.High[brick] - wide.Low[brick]) >=
              visibility.LeastGradient);
        isOccupied =
          isOccupied && (visibility.ShownByMask.empty() || visibility.ShownByMask[brick] != 0);
        const int x = static_cast<int>(brick % grid.Counts[0]);
        const int y = static_cast<int>(brick / grid.Counts[0] % grid.Counts[1]);
        const int z = static_cast<int>(brick / grid.Counts[0] / grid.Counts[1]);
        isOccupied =
          isOccupied && (!visibility.Regions.On || IsShown(visibility.Regions, grid, { x, y, z }));
        occupied[brick] = isOccupied ? 1 : 0;
      }
    });
  return occupied;
}

//------------------------------------------------------------------------------
BrickBox FindBoxOfOccupied(const std::vector<unsigned char>& occupied, const BrickGrid& grid)
{
  BrickBox box = { grid.Counts, { -1, -1, -1 } };
  for (int brick = 0; brick < static_cast<int>(occupied.size()); ++brick)
  {
    if (!occupied[brick])
    {
      continue;
    }
    const std::array<int, 3> at = { brick % grid.Counts[0], brick / grid.Counts[0] % grid.Counts[1],
      brick / (grid.Counts[0] * grid.Counts[1]) };
    for (int axis = 0; axis < 3; ++axis)
    {
      box.First[axis] = std::min(box.First[axis], at[axis]);
      box.Last[axis] = std::max(box.Last[axis], at[axis]);
    }
  }
  return box;
}

//------------------------------------------------------------------------------
std::vector<int> FindOuterBricks(const std::vector<unsigned char>& occupied, const BrickGrid& grid)
{
  const auto& counts = grid.Counts;
  const std::array<int, 3> strides = { 1, counts[0], counts[0] * counts[1] };
  const auto isOuter = [&](int brick)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const int at = brick / strides[axis] % counts[axis];
      if (at == 0 || at + 1 == counts[axis] || !occupied[brick - strides[axis]] ||
        !occupied[brick + strides[axis]])
      {
        return true;
      }
    }
    return false;
  };
  std::vector<int> outer;
  for (int brick = 0; brick < static_cast<int>(occupied.size()); ++brick)
  {
    if (occupied[brick] && isOuter(brick))
    {
      outer.push_back(brick);
    }
  }
  return outer;
}

//------------------------------------------------------------------------------
BrickMap MapToBricks(const BrickGrid& grid)
{
  BrickMap map;
  for (int axis = 0; axis < 3; ++axis)
  {
    // A single voxel lies in the middle of the only brick, wherever a ray passes it.
    const bool isFlat = grid.Dimensions[axis] <= 1;
    map.Scale[axis] = isFlat ? 0.0 : static_cast<double>(grid.Dimensions[axis]) / grid.Edge;
    map.Offset[axis] = isFlat ? 0.5 : -0.5 / grid.Edge;
  }
  return map;
}

//------------------------------------------------------------------------------
TextureBox PlaceBricks(const BrickBox& bricks, const BrickGrid& grid)
{
  TextureBox box;
  const auto [scale, offset] = MapToBricks(grid);
  for (int axis = 0; axis < 3; ++axis)
  {
    const int first = bricks.First[axis];
    const int behind = bricks.Last[axis] + 1;
    if (first < behind && first > 0)
    {
      box.Low[axis] = (first - offset[axis]) / scale[axis];
    }
    if (first < behind && behind < grid.Counts[axis])
    {
      box.High[axis] = (behind - offset[axis]) / scale[axis];
    }
  }
  return box;
}

//------------------------------------------------------------------------------
std::vector<unsigned char> ComputeEmptyCubes(
  const std::vector<unsigned char>& occupied, const BrickGrid& grid)
{
  constexpr int octants = 8;
  std::vector<unsigned char> cubes(octants * occupied.size());
  vtkSMPTools::For(0, octants, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType octant = begin; octant < end; ++octant)
      {
        const std::array<int, 3> ahead = { octant & 1 ? -1 : 1, octant & 2 ? -1 : 1,
          octant & 4 ? -1 : 1 };
        FindCubes(occupied, grid, ahead, &cubes[octant * occupied.size()]);
      }
    });
  return cubes;
}

}
