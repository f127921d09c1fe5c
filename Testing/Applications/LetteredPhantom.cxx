#include "LetteredPhantom.h"

#include <cmath>

namespace
{

constexpr int LetterWidth = 5;
constexpr int LetterHeight = 7;
constexpr int LetterBottom = 5;
constexpr int LetterStarts[2] = { 4, 15 };
constexpr int FrontDepth = 3;

const char* const Letters[2][LetterHeight] = {
  { "####.", "#...#", "#...#", "####.", "#.#..", "#..#.", "#...#" },
  { "#....", "#....", "#....", "#....", "#....", "#....", "#####" },
};

bool IsLetter(int letter, int column, int row)
{
  const bool isInside = column >= 0 && column < LetterWidth && row >= 0 && row < LetterHeight;
  return isInside && Letters[letter][LetterHeight - 1 - row][column] == '#';
}

// The voxel of a pixel, by its place.
int VoxelAt(double place, int axis)
{
  return static_cast<int>(std::lround(place - LetteredPhantom::Origin[axis]));
}

}

int LetteredPhantom::At(int x, int y, int z)
{
  if (y >= FrontDepth)
  {
    return Block;
  }
  for (int letter = 0; letter < 2; ++letter)
  {
    if (y > 0 && IsLetter(letter, x - LetterStarts[letter], z - LetterBottom))
    {
      return Letter;
    }
  }
  return 0;
}

DicomSlices LetteredPhantom::Slices(const Vector& row, const Vector& column)
{
  auto first = Slice(0);
  SetOrientation(first, row, column);
  const Vector normal = Normal(first);
  Vector corner{};
  int counts[3] = { 1, 1, 1 };
  const Vector* const directions[3] = { &row, &column, &normal };
  for (int axis = 0; axis < 3; ++axis)
  {
    corner[axis] = Origin[axis];
    for (int index = 0; index < 3; ++index)
    {
      const double along = (*directions[index])[axis];
      counts[index] = along != 0.0 ? Size[axis] : counts[index];
      corner[axis] += along < 0.0 ? Size[axis] - 1 : 0;
    }
  }
  DicomSlices slices;
  for (int number = 0; number < counts[2]; ++number)
  {
    auto slice = Slice(number);
    slice.columns = counts[0];
    slice.rows = counts[1];
    slice.elements["PixelSpacing"] = "1\\1";
    SetOrientation(slice, row, column);
    SetPosition(slice,
      { corner[0] + number * normal[0], corner[1] + number * normal[1],
        corner[2] + number * normal[2] });
    slice.stored = [slice](int i, int j, int)
    {
      const Vector place = Place(slice, i, j);
      return At(VoxelAt(place[0], 0), VoxelAt(place[1], 1), VoxelAt(place[2], 2));
    };
    slices.push_back(slice);
  }
  return slices;
}

std::vector<LetteredPhantom::Cell> LetteredPhantom::Cells()
{
  std::vector<Cell> cells;
  for (int letter = 0; letter < 2; ++letter)
  {
    for (int row = 0; row < LetterHeight; ++row)
    {
      for (int column = 0; column < LetterWidth; ++column)
      {
        cells.push_back(
          { LetterStarts[letter] + column, LetterBottom + row, IsLetter(letter, column, row) });
      }
    }
  }
  return cells;
}
