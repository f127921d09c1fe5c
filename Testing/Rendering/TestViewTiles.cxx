#include "Catch.h"
#include "EmptySpace.h"
#include "ViewTiles.h"
#include "ViewedVolume.h"

#include <algorithm>
#include <cmath>

using namespace penumbra;

namespace
{
constexpr int Width = 250;
constexpr int Height = 200;

// Ends of brick along axis, in texture coordinates.
std::array<double, 2> GetEnds(const BrickGrid& grid, int brick, int axis)
{
  const double voxels = grid.Dimensions[axis];
  return voxels == 1.0 ? std::array<double, 2>{ 0.0, 1.0 }
                       : std::array<double, 2>{ (grid.GetFirst(brick) + 0.5) / voxels,
                           (grid.GetLast(brick, axis) + 0.5) / voxels };
}

Vector3 RandomPointInBrick(const BrickGrid& grid, int brick, std::mt19937& generator)
{
  const auto& counts = grid.Counts;
  const int at[3] = { brick % counts[0], brick / counts[0] % counts[1],
    brick / (counts[0] * counts[1]) };
  Vector3 point;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto [low, high] = GetEnds(grid, at[axis], axis);
    point[axis] = std::uniform_real_distribution<double>(low, high)(generator);
  }
  return point;
}

int CountHolding(const ViewTiles& tiles, const Vector3& image)
{
  return static_cast<int>(std::count_if(tiles.Rectangles.begin(), tiles.Rectangles.end(),
    [&](const std::array<float, 4>& rectangle)
    {
      return image[0] >= rectangle[0] && image[0] < rectangle[2] && image[1] >= rectangle[1] &&
        image[1] < rectangle[3];
    }));
}

// Of a picture's pixels, in their middles.
int CountPixels(const ViewTiles& tiles, int width, int height, int holding)
{
  int count = 0;
  for (int pixel = 0; pixel < width * height; ++pixel)
  {
    const Vector3 image = { 2.0 * (pixel % width + 0.5) / width - 1.0,
      2.0 * (pixel / width + 0.5) / height - 1.0, 0.0 };
    count += CountHolding(tiles, image) == holding;
  }
  return count;
}

bool IsInside(const Vector3& image)
{
  return std::abs(image[0]) < 1.0 && std::abs(image[1]) < 1.0;
}

// Clip coordinates of a picture that shows the box of texture coordinates from its front, whole.
constexpr Matrix4 FromFront = { 2, 0, 0, -1, 0, 2, 0, -1, 0, 0, 2, -1, 0, 0, 0, 1 };
}

TEST_CASE("Tiles hold all pixels that a brick is seen in, each once")
{
  std::mt19937 generator(7);
  int seen = 0;
  for (const PlacedVolume& volume : MakePlacedVolumes())
  {
    for (const View& view : MakeViews())
    {
      INFO(volume.name << ", " << view.name);
      const ViewedVolume viewed(volume, view);
      const BrickGrid grid = MakeBrickGrid(viewed.geometry.Dimensions, 2);
      std::vector<int> bricks(3);
      for (int& brick : bricks)
      {
        brick = std::uniform_int_distribution<int>(0, grid.GetNumberOfBricks() - 1)(generator);
      }
      const ViewTiles tiles = FindViewTiles(bricks, grid, viewed.rays.TextureToClip, Width, Height);
      CHECK(tiles.Rectangles.size() <= ViewTiles::Most);
      for (int sample = 0; sample < 60 && !tiles.Everywhere; ++sample)
      {
        const Vector3 point = RandomPointInBrick(grid, bricks[sample % 3], generator);
        const Vector3 image = viewed.Project(point);
        if ((viewed.camera->GetParallelProjection() || viewed.Depth(point) > 0.0) &&
          IsInside(image))
        {
          ++seen;
          CHECK(CountHolding(tiles, image) == 1);
        }
      }
    }
  }
  CHECK(seen > 1000);
}

TEST_CASE("Tiles hold little more than what is seen")
{
  const BrickGrid grid = MakeBrickGrid({ 33, 33, 33 }, 4);
  // The brick from voxel 8 to 12 along x and 16 to 20 along y: 62 of 512 pixels along each axis.
  const ViewTiles tiles = FindViewTiles({ 2 + 8 * 4 }, grid, FromFront, 512, 512);
  REQUIRE(tiles.Rectangles.size() == 1);
  const auto& rectangle = tiles.Rectangles.front();
  const double begin[2] = { 8.5 / 33.0, 16.5 / 33.0 };
  for (const int axis : { 0, 1 })
  {
    // Ends lie between tiles of eight pixels, one more is for rounding.
    const double low = (rectangle[axis] + 1.0) * 256.0;
    const double high = (rectangle[axis + 2] + 1.0) * 256.0;
    CHECK(std::fmod(low, 8.0) == 0.0);
    CHECK(std::fmod(high, 8.0) == 0.0);
    CHECK(low <= begin[axis] * 512.0);
    CHECK(low > begin[axis] * 512.0 - 9.0);
    CHECK(high >= (begin[axis] + 4.0 / 33.0) * 512.0);
    CHECK(high < (begin[axis] + 4.0 / 33.0) * 512.0 + 9.0);
  }
}

TEST_CASE("Tiles never overlap, and are larger where they would be too many")
{
  const int size = GENERATE(64, 300, 513);
  const BrickGrid grid = MakeBrickGrid({ 129, 129, 2 }, 2);
  std::mt19937 generator(3);
  std::vector<int> bricks;
  for (int brick = 0; brick < grid.GetNumberOfBricks(); ++brick)
  {
    if (generator() % 16 == 0)
    {
      bricks.push_back(brick);
    }
  }
  const ViewTiles tiles = FindViewTiles(bricks, grid, FromFront, size, size);
  CHECK(tiles.Rectangles.size() <= ViewTiles::Most);
  const int once = CountPixels(tiles, size, size, 1);
  CHECK(once >= size * size / 16);
  CHECK(once + CountPixels(tiles, size, size, 0) == size * size);
}

TEST_CASE("Where matter surrounds the eye it is seen everywhere, where it is behind nowhere")
{
  const BrickGrid grid = MakeBrickGrid({ 9, 9, 9 }, 4);
  // The eye at z = depth looks down along z.
  const auto see = [&](double depth)
  {
    const Matrix4 textureToClip = { 1, 0, 0, -0.5, 0, 1, 0, -0.5, 0, 0, -1, 0, 0, 0, -1, depth };
    return FindViewTiles({ 0 }, grid, textureToClip, Width, Height);
  };
  const double face = 4.5 / 9.0;
  CHECK_FALSE(see(face + 0.01).Everywhere);
  CHECK_FALSE(see(face + 0.01).Rectangles.empty());
  CHECK(see(face - 0.01).Everywhere);
  CHECK_FALSE(see(0.5 / 9.0 - 0.01).Everywhere);
  CHECK(see(0.5 / 9.0 - 0.01).Rectangles.empty());
  CHECK(FindViewTiles({}, grid, FromFront, Width, Height).Rectangles.empty());
}

TEST_CASE("Outer bricks are those with an empty side")
{
  const BrickGrid grid = MakeBrickGrid({ 21, 21, 21 }, 4);
  std::vector<unsigned char> occupied(125, 1);
  // All on the volume's faces; within them 3 x 3 x 3 with a hole in the middle, whose six sides are
  // in sight of it.
  CHECK(FindOuterBricks(occupied, grid).size() == 98);
  occupied[62] = 0;
  const std::vector<int> outer = FindOuterBricks(occupied, grid);
  CHECK(outer.size() == 104);
  CHECK(std::count(outer.begin(), outer.end(), 62) == 0);
  CHECK(std::count(outer.begin(), outer.end(), 61) == 1);
  CHECK(FindOuterBricks(std::vector<unsigned char>(125, 0), grid).empty());
}
