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
