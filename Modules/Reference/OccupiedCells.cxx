#include "OccupiedCells.h"

#include "TransferFunctions.h"

#include <algorithm>

namespace penumbra::reference
{

//------------------------------------------------------------------------------
OccupiedCells::OccupiedCells(const ScalarField& field, const ExtinctionFunction& extinction)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Counts[axis] = std::max(1, field.GetDimensions()[axis] - 1);
    this->BrickCounts[axis] = (this->Counts[axis] + BrickSize - 1) / BrickSize;
  }
  const auto count = [](const std::array<int, 3>& counts)
  { return static_cast<std::size_t>(counts[0]) * counts[1] * counts[2]; };
  this->Cells.resize(count(this->Counts));
  this->Bricks.resize(count(this->BrickCounts));
  std::array<int, 3> cell;
  for (cell[2] = 0; cell[2] < this->Counts[2]; ++cell[2])
  {
    for (cell[1] = 0; cell[1] < this->Counts[1]; ++cell[1])
    {
      for (cell[0] = 0; cell[0] < this->Counts[0]; ++cell[0])
      {
        const CellCorners corners = field.GetCorners(cell);
        const auto [low, high] = std::minmax_element(corners.begin(), corners.end());
        if (!extinction.IsZero(*low, *high))
        {
          const std::array<int, 3> brick = { cell[0] / BrickSize, cell[1] / BrickSize,
            cell[2] / BrickSize };
          this->Cells[Number(cell, this->Counts)] = 1;
          this->Bricks[Number(brick, this->BrickCounts)] = 1;
        }
      }
    }
  }
}

}
