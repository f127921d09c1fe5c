#include "Catch.h"
#include "EmptySpace.h"
#include "VisibleScalars.h"

#include <vtkVolumeMapper.h>

using namespace penumbra;

namespace
{
// Four bricks of four cells in a row, the second of them with scalars of 5 to 6, the others 0.
ScalarBricks MakeRow()
{
  return { MakeBrickGrid({ 17, 2, 2 }, 4), { 0, 5, 0, 0 }, { 0, 6, 0, 0 } };
}

// Scalars of 4 to 6 are visible, or all of them.
VisibleScalars MakeVisible(bool all)
{
  TransferFunctionTable table;
  table.High = 10.0;
  table.Extinction.assign(11, all ? 1.0f : 0.0f);
  table.Extinction[5] = 1.0f;
  return VisibleScalars(table);
}

using Bricks = std::vector<unsigned char>;
}

TEST_CASE("A brick is occupied where the opacity function shows any of its scalars")
{
  CHECK(FindOccupiedBricks(MakeRow(), MakeVisible(false), {}) == Bricks{ 0, 1, 0, 0 });
  CHECK(FindOccupiedBricks(MakeRow(), MakeVisible(true), {}) == Bricks{ 1, 1, 1, 1 });
}

TEST_CASE("A mask leaves the bricks that it shows")
{
  BrickVisibility visibility;
  visibility.ShownByMask = { 1, 0, 1, 0 };
  CHECK(FindOccupiedBricks(MakeRow(), MakeVisible(true), visibility) == Bricks{ 1, 0, 1, 0 });
}

TEST_CASE("Gradients reach as far as the neighbours of a brick")
{
  BrickVisibility visibility;
  visibility.GradientBound = 0.5;
  visibility.LeastGradient = 3.0;
  CHECK(FindOccupiedBricks(MakeRow(), MakeVisible(true), visibility) == Bricks{ 1, 1, 1, 0 });
  visibility.LeastGradient = 3.1;
  CHECK(FindOccupiedBricks(MakeRow(), MakeVisible(true), visibility) == Bricks{ 0, 0, 0, 0 });
}

TEST_CASE("Cropping to regions leaves the bricks that they reach")
{
  BrickVisibility visibility;
  visibility.Regions = { true, VTK_CROP_SUBVOLUME, { 3.0, -1.0, -1.0 }, { 7.9, 2.0, 2.0 } };
  CHECK(FindOccupiedBricks(MakeRow(), MakeVisible(true), visibility) == Bricks{ 1, 1, 0, 0 });
  // All but that.
  visibility.Regions.Flags = 0x7ffdfff;
  CHECK(FindOccupiedBricks(MakeRow(), MakeVisible(true), visibility) == Bricks{ 1, 1, 1, 1 });
  visibility.Regions.Low[0] = -0.5;
  CHECK(FindOccupiedBricks(MakeRow(), MakeVisible(true), visibility) == Bricks{ 0, 1, 1, 1 });
}

TEST_CASE("The only voxel of an axis is half a voxel thick to each side")
{
  const ScalarBricks flat = { MakeBrickGrid({ 5, 5, 1 }, 4), { 5 }, { 5 } };
  BrickVisibility visibility;
  visibility.Regions = { true, VTK_CROP_SUBVOLUME, { -1.0, -1.0, 0.2 }, { 9.0, 9.0, 9.0 } };
  CHECK(FindOccupiedBricks(flat, MakeVisible(true), visibility) == Bricks{ 1 });
  visibility.Regions.Low[2] = 0.6;
  CHECK(FindOccupiedBricks(flat, MakeVisible(true), visibility) == Bricks{ 0 });
}

TEST_CASE("The box of the occupied bricks is the smallest one around them")
{
  const BrickGrid grid = MakeBrickGrid({ 17, 13, 9 }, 4);
  Bricks occupied(4 * 3 * 2, 0);
  const auto occupy = [&](int x, int y, int z) { occupied[x + 4 * (y + 3 * z)] = 1; };
  CHECK(FindBoxOfOccupied(occupied, grid).Last[0] < FindBoxOfOccupied(occupied, grid).First[0]);
  occupy(2, 1, 1);
  CHECK(FindBoxOfOccupied(occupied, grid).First == std::array<int, 3>{ 2, 1, 1 });
  CHECK(FindBoxOfOccupied(occupied, grid).Last == std::array<int, 3>{ 2, 1, 1 });
  occupy(1, 2, 0);
  CHECK(FindBoxOfOccupied(occupied, grid).First == std::array<int, 3>{ 1, 1, 0 });
  CHECK(FindBoxOfOccupied(occupied, grid).Last == std::array<int, 3>{ 2, 2, 1 });
}

TEST_CASE("Bricks lie between their voxels' centres, and the outer ones reach to the faces")
{
  // Along x bricks of four cells from voxel 0, 4, 8 and 12 on; one brick along y; one voxel along
  // z.
  const BrickGrid grid = MakeBrickGrid({ 17, 5, 1 }, 4);
  const TextureBox inner = PlaceBricks({ { 1, 0, 0 }, { 2, 0, 0 } }, grid);
  CHECK(inner.Low[0] == Approx(4.5 / 17.0));
  CHECK(inner.High[0] == Approx(12.5 / 17.0));
  for (const int axis : { 1, 2 })
  {
    CHECK(inner.Low[axis] == 0.0);
    CHECK(inner.High[axis] == 1.0);
  }
  const TextureBox none = PlaceBricks({}, grid);
  CHECK(none.Low[0] == 0.0);
  CHECK(none.High[0] == 1.0);
}
