/**
 * @file    EmptyBricks.h
 * @brief   where in a volume there is nothing, brick by brick
 *
 * A brick is a cube of cells between voxels. It is empty where the opacity function is 0 over the
 * whole range of the voxels at its cells' corners, so that no interpolated value in it has any
 * opacity. Each empty brick knows its distance from the next one that is not, in bricks along the
 * longest axis (Chebyshev), so that a ray crosses many at once.
 */

#ifndef EmptyBricks_h
#define EmptyBricks_h

#include "ShadowRay.h"

#include "vtkType.h"

#include <functional>
#include <vector>

class vtkDataArray;

namespace penumbra
{

class EmptyBricks
{
public:
  static constexpr int CellsPerBrick = 4;

  /// True where no scalar between the two, both included, has any opacity.
  using EmptyRange = std::function<bool(double low, double high)>;

  EmptyBricks(
    vtkDataArray* scalars, const std::array<int, 3>& dimensions, const EmptyRange& isEmpty);

  /// Whether nothing is around this cell, and if so how far along the ray at least nothing is.
  bool FindEmptyRun(const std::array<int, 3>& cell, const ShadowRay& ray, double& end) const
  {
    const std::array<int, 3> brick = { cell[0] / CellsPerBrick, cell[1] / CellsPerBrick,
      cell[2] / CellsPerBrick };
    const int distance = this->Distances[this->GetBrick(brick[0], brick[1], brick[2])];
    end = distance > 0 ? GetEnd(brick, distance, ray) : 0.0;
    return distance > 0;
  }

private:
  vtkIdType GetBrick(int x, int y, int z) const
  {
    return x +
      static_cast<vtkIdType>(this->Counts[0]) * (y + static_cast<vtkIdType>(this->Counts[1]) * z);
  }
  static double GetEnd(const std::array<int, 3>& brick, int distance, const ShadowRay& ray);
  void SpreadDistances();
  void LowerDistance(int x, int y, int z, bool forward);

  std::array<int, 3> Counts;
  std::vector<unsigned char> Distances;
};

}

#endif
