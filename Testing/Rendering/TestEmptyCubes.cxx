#include "Catch.h"
#include "EmptySpace.h"

#include <random>

using namespace penumbra;

namespace
{
const BrickGrid Grid = MakeBrickGrid({ 21, 17, 13 }, 4);

int GetBrick(int x, int y, int z)
{
  return (z * Grid.Counts[1] + y) * Grid.Counts[0] + x;
}

bool IsInside(int x, int y, int z)
{
  return x >= 0 && x < Grid.Counts[0] && y >= 0 && y < Grid.Counts[1] && z >= 0 &&
    z < Grid.Counts[2];
}

std::vector<unsigned char> MakeRandomBricks(int oneIn)
{
  std::mt19937 random(11);
  std::vector<unsigned char> occupied(Grid.GetNumberOfBricks());
  for (unsigned char& brick : occupied)
  {
    brick = random() % oneIn == 0 ? 1 : 0;
  }
  return occupied;
}

// Whether the cube that begins at a brick and lies ahead of it in an octant is empty.
bool IsEmpty(
  const std::vector<unsigned char>& occupied, const std::array<int, 3>& brick, int edge, int octant)
{
  for (int k = 0; k < edge * edge * edge; ++k)
  {
    const int x = brick[0] + (octant & 1 ? -1 : 1) * (k % edge);
    const int y = brick[1] + (octant & 2 ? -1 : 1) * (k / edge % edge);
    const int z = brick[2] + (octant & 4 ? -1 : 1) * (k / edge / edge);
    if (IsInside(x, y, z) && occupied[GetBrick(x, y, z)])
    {
      return false;
    }
  }
  return true;
}
}

TEST_CASE("Each cube is empty, and the next larger one is not")
{
  const int oneIn = GENERATE(2, 8, 40);
  const std::vector<unsigned char> occupied = MakeRandomBricks(oneIn);
  const std::vector<unsigned char> cubes = ComputeEmptyCubes(occupied, Grid);
  REQUIRE(cubes.size() == 8 * occupied.size());
  int wrong = 0;
  for (int octant = 0; octant < 8; ++octant)
  {
    for (int brick = 0; brick < Grid.GetNumberOfBricks(); ++brick)
    {
      const std::array<int, 3> at = { brick % Grid.Counts[0],
        brick / Grid.Counts[0] % Grid.Counts[1], brick / Grid.Counts[0] / Grid.Counts[1] };
      const int edge = cubes[octant * occupied.size() + brick];
      wrong += edge > 0 && !IsEmpty(occupied, at, std::min(edge, 8), octant);
      wrong += edge < 8 && IsEmpty(occupied, at, edge + 1, octant);
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("Without matter all cubes reach far beyond the volume")
{
  const std::vector<unsigned char> cubes =
    ComputeEmptyCubes(std::vector<unsigned char>(Grid.GetNumberOfBricks(), 0), Grid);
  CHECK(std::all_of(cubes.begin(), cubes.end(), [](unsigned char edge) { return edge == 255; }));
}
