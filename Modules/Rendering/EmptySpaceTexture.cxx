#include "EmptySpaceTexture.h"

#include "MatrixUniforms.h"
#include "TextureSampling.h"
#include "VisibleScalars.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace penumbra
{
namespace
{
constexpr int BrickEdge = 4;
// The map of a large volume stays small beside it, and is made within a tenth of a second.
constexpr int LargestNumberOfBricks = 600000;

BrickGrid ChooseGrid(const std::array<int, 3>& dimensions)
{
  BrickGrid grid = MakeBrickGrid(dimensions, BrickEdge);
  while (grid.GetNumberOfBricks() > LargestNumberOfBricks)
  {
    grid = MakeBrickGrid(dimensions, 2 * grid.Edge);
  }
  return grid;
}

double GetExtinction(const TransferFunctionTable& table, double scalar)
{
  const double last = table.GetSize() - 1.0;
  const double entry = (scalar - table.Low) / (table.High - table.Low) * last;
  return table.Extinction[static_cast<std::size_t>(std::clamp(std::round(entry), 0.0, last))];
}

// The largest extinction of a brick is taken from both ends and the middle of its scalars.
double ComputeMeanExtinction(const ScalarBricks& bricks, const std::vector<unsigned char>& occupied,
  const TransferFunctionTable& table)
{
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t brick = 0; brick < occupied.size(); ++brick)
  {
    if (occupied[brick])
    {
      const double low = bricks.Low[brick];
      const double high = bricks.High[brick];
      sum += std::max({ GetExtinction(table, low), GetExtinction(table, 0.5 * low + 0.5 * high),
        GetExtinction(table, high) });
      ++count;
    }
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}
}

//------------------------------------------------------------------------------
VolumePlacement EmptySpaceReport::DrawIn(const VolumePlacement& placement) const
{
  VolumePlacement drawnIn = placement;
  for (int axis = 0; axis < 3; ++axis)
  {
    drawnIn.BoxLow[axis] = std::max(placement.BoxLow[axis], this->Matter.Low[axis]);
    drawnIn.BoxHigh[axis] = std::min(placement.BoxHigh[axis], this->Matter.High[axis]);
  }
  return drawnIn;
}

//------------------------------------------------------------------------------
bool EmptySpaceReport::Helps() const
{
  constexpr double leastShare = 0.1;
  return this->Bricks - this->OccupiedBricks > leastShare * this->Bricks;
}

//------------------------------------------------------------------------------
void EmptySpaceTexture::ForgetScalars()
{
  this->Bricks = {};
}

//------------------------------------------------------------------------------
void EmptySpaceTexture::ComputeBricks(
  vtkDataArray* scalars, const std::array<int, 3>& dimensions, const ScalarRange& range)
{
  this->Bricks = ComputeScalarBricks(scalars, ChooseGrid(dimensions), range);
}

//------------------------------------------------------------------------------
void EmptySpaceTexture::Load(vtkOpenGLRenderWindow* window, const TransferFunctionTable& table,
  const BrickVisibility& visibility)
{
  const BrickGrid& grid = this->Bricks.Grid;
  const std::vector<unsigned char> occupied =
    FindOccupiedBricks(this->Bricks, VisibleScalars(table), visibility);
  const auto count = std::count(occupied.begin(), occupied.end(), 1);
  this->Report = { grid.Edge, grid.GetNumberOfBricks(), static_cast<int>(count),
    ComputeMeanExtinction(this->Bricks, occupied, table) };
  this->Report.Matter = PlaceBricks(FindBoxOfOccupied(occupied, grid), grid);
  this->OuterBricks = FindOuterBricks(occupied, grid);
  std::vector<unsigned char> cubes = ComputeEmptyCubes(occupied, grid);
  constexpr int octants = 8;
  ResetTexture(this->Texture, window, vtkTextureObject::Nearest);
  this->Texture->Create3DFromRaw(
    grid.Counts[0], grid.Counts[1], octants * grid.Counts[2], 1, VTK_UNSIGNED_CHAR, cubes.data());
}

//------------------------------------------------------------------------------
void EmptySpaceTexture::SetUniforms(vtkShaderProgram* program) const
{
  SetSampler(program, "scene_emptyCubes", this->Texture);
  const BrickGrid& grid = this->Bricks.Grid;
  const auto [scale, offset] = MapToBricks(grid);
  SetUniform(program, "scene_bricks", scale);
  SetUniform(program, "scene_lastBrick",
    Vector3{ grid.Counts[0] - 1.0, grid.Counts[1] - 1.0, grid.Counts[2] - 1.0 });
  SetUniform(program, "scene_brickOffset", offset);
}

//------------------------------------------------------------------------------
void EmptySpaceTexture::Release(vtkOpenGLRenderWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->Report = {};
  this->OuterBricks.clear();
}

}
