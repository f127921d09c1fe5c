#include "Catch.h"
#include "MakeArray.h"
#include "ScalarBricks.h"
#include "ScalarRange.h"

#include <algorithm>
#include <limits>
#include <random>

using namespace penumbra;

namespace
{
std::vector<double> MakeRandomValues(const std::array<int, 3>& dimensions, double largest)
{
  std::mt19937 random(7);
  std::vector<double> values(dimensions[0] * dimensions[1] * dimensions[2]);
  for (double& value : values)
  {
    value = static_cast<double>(random()) / random.max() * largest;
  }
  return values;
}
}

TEST_CASE("Bricks cover all cells, and neighbours share the voxels of their face")
{
  const BrickGrid grid = MakeBrickGrid({ 9, 10, 1 }, 4);
  CHECK(grid.Counts == std::array<int, 3>{ 2, 3, 1 });
  CHECK(grid.GetNumberOfBricks() == 6);
  CHECK(grid.GetFirst(1) == grid.GetLast(0, 0));
  CHECK(grid.GetLast(1, 0) == 8);
  CHECK(grid.GetLast(2, 1) == 9);
  CHECK(grid.GetLast(0, 2) == 0);
  CHECK(MakeBrickGrid({ 1, 2, 5 }, 4).Counts == std::array<int, 3>{ 1, 1, 1 });
}

TEST_CASE("A brick's range is that of its voxels, for every type of scalar")
{
  const std::array<int, 3> dimensions = { 11, 7, 6 };
  const int type = GENERATE(VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_INT, VTK_FLOAT, VTK_DOUBLE);
  const auto scalars = MakeArray(type, MakeRandomValues(dimensions, 200.0));
  const BrickGrid grid = MakeBrickGrid(dimensions, 4);
  const ScalarBricks bricks = ComputeScalarBricks(scalars, grid, ComputeScalarRange(scalars));
  const std::array<int, 3> brick = { 2, 1, 1 };
  double low = 1e9;
  double high = -1e9;
  for (int z = 4; z <= 5; ++z)
  {
    for (int y = 4; y <= 6; ++y)
    {
      for (int x = 8; x <= 10; ++x)
      {
        const double value = scalars->GetComponent((z * 7 + y) * 11 + x, 0);
        low = std::min(low, value);
        high = std::max(high, value);
      }
    }
  }
  const int index = (brick[2] * grid.Counts[1] + brick[1]) * grid.Counts[0] + brick[0];
  CHECK(bricks.Low[index] == low);
  CHECK(bricks.High[index] == high);
}

TEST_CASE("Voxels that are not finite count as they are drawn")
{
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto scalars = MakeArray(VTK_DOUBLE, { 5, nan, 3, 4, 4, infinity, 4, 4, -infinity });
  const ScalarRange range = ComputeScalarRange(scalars);
  const ScalarBricks bricks = ComputeScalarBricks(scalars, MakeBrickGrid({ 9, 1, 1 }, 4), range);
  CHECK(bricks.Low == std::vector<double>{ 3, 3 });
  CHECK(bricks.High == std::vector<double>{ 5, 5 });
}

TEST_CASE("A widened brick holds the ranges of all 26 neighbours")
{
  const BrickGrid grid = MakeBrickGrid({ 7, 7, 7 }, 2);
  REQUIRE(grid.Counts == std::array<int, 3>{ 3, 3, 3 });
  ScalarBricks bricks{ grid, std::vector<double>(27, 0.0), std::vector<double>(27, 0.0) };
  bricks.Low[0] = -1.0;
  bricks.High[26] = 1.0;
  const ScalarBricks wide = WidenToNeighbours(bricks);
  CHECK(wide.Low[13] == -1.0);
  CHECK(wide.High[13] == 1.0);
  CHECK(wide.High[0] == 0.0);
  CHECK(wide.Low[26] == 0.0);
  CHECK(std::count(wide.Low.begin(), wide.Low.end(), -1.0) == 8);
}

TEST_CASE("A brick is shown where the mask shows one of its voxels, shared ones too")
{
  std::vector<double> mask(9 * 3, 0.0);
  mask[9 + 4] = 2.0;
  const auto array = MakeArray(VTK_UNSIGNED_CHAR, mask);
  CHECK(
    FindShownBricks(array, MakeBrickGrid({ 9, 3, 1 }, 4)) == std::vector<unsigned char>{ 1, 1 });
  mask[9 + 4] = 0.0;
  mask[9 + 5] = 1.0;
  CHECK(FindShownBricks(MakeArray(VTK_UNSIGNED_CHAR, mask), MakeBrickGrid({ 9, 3, 1 }, 4)) ==
    std::vector<unsigned char>{ 0, 1 });
}
