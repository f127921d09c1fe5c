/**
 * @file    ScalarBricks.h
 * @brief   a volume's scalars in bricks: the smallest and the largest of each
 *
 * Bricks are cubes of cells. A cell lies between neighbouring voxels, so neighbouring bricks share
 * the voxels of their common face, and no interpolated scalar within a brick is outside of its
 * range. The last bricks of an axis may be smaller.
 */

#ifndef ScalarBricks_h
#define ScalarBricks_h

#include "PenumbraRenderingModule.h" // For export macro

#include <array>
#include <vector>

class vtkDataArray;

namespace penumbra
{

struct ScalarRange;

/// How a volume is cut into bricks.
struct PENUMBRARENDERING_EXPORT BrickGrid
{
  std::array<int, 3> Dimensions{}; ///< of the volume, in voxels
  std::array<int, 3> Counts{};     ///< bricks along each axis, at least 1
  int Edge = 1;                    ///< in cells

  int GetNumberOfBricks() const { return this->Counts[0] * this->Counts[1] * this->Counts[2]; }
  /// First and last voxel of brick along axis.
  int GetFirst(int brick) const { return brick * this->Edge; }
  int GetLast(int brick, int axis) const;
};

PENUMBRARENDERING_EXPORT BrickGrid MakeBrickGrid(const std::array<int, 3>& dimensions, int edge);

struct ScalarBricks
{
  BrickGrid Grid;
  std::vector<double> Low; ///< one a brick, x fastest
  std::vector<double> High;
};

/// Of the first component. NaN and -Inf count as the smallest of range, +Inf as its largest.
PENUMBRARENDERING_EXPORT ScalarBricks ComputeScalarBricks(
  vtkDataArray* scalars, const BrickGrid& grid, const ScalarRange& range);

/// The same bricks, each with the range of itself and of all its neighbours.
PENUMBRARENDERING_EXPORT ScalarBricks WidenToNeighbours(const ScalarBricks& bricks);

/// 1 for each brick with a voxel that the mask shows, which is where it is not 0.
PENUMBRARENDERING_EXPORT std::vector<unsigned char> FindShownBricks(
  vtkDataArray* mask, const BrickGrid& grid);

}

#endif
