/**
 * @file    OccupiedCells.h
 * @brief   which cells of a volume can have extinction at all
 *
 * By the smallest and the largest value of a cell's corners, between which all its values are: what
 * is left out has no extinction anywhere.
 */

#ifndef OccupiedCells_h
#define OccupiedCells_h

#include "ScalarField.h"

#include <array>
#include <vector>

namespace penumbra::reference
{

class ExtinctionFunction;

class OccupiedCells
{
public:
  /// Of cells, along each axis of a brick.
  static constexpr int BrickSize = 8;

  OccupiedCells(const ScalarField& field, const ExtinctionFunction& extinction);

  /// An axis of one voxel has one cell.
  const std::array<int, 3>& GetCounts() const { return this->Counts; }
  const std::array<int, 3>& GetBrickCounts() const { return this->BrickCounts; }

  bool IsOccupied(const std::array<int, 3>& cell) const
  {
    return this->Cells[Number(cell, this->Counts)] != 0;
  }
  bool IsBrickOccupied(const std::array<int, 3>& brick) const
  {
    return this->Bricks[Number(brick, this->BrickCounts)] != 0;
  }

private:
  static std::size_t Number(const std::array<int, 3>& block, const std::array<int, 3>& counts)
  {
    return block[0] +
      static_cast<std::size_t>(counts[0]) *
      (block[1] + static_cast<std::size_t>(counts[1]) * block[2]);
  }

  std::array<int, 3> Counts{};
  std::array<int, 3> BrickCounts{};
  std::vector<unsigned char> Cells;
  std::vector<unsigned char> Bricks;
};

}

#endif
