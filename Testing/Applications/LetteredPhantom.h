/**
 * @file LetteredPhantom.h
 * @brief A block with an R and an L on its front, as a scanner might store it.
 *
 * In the patient's axes (x to the left, y to the back, z to the head; mm) the block has 24 x 12 x
 * 16 voxels of 1 mm. The letters are 5 x 7 voxels on its front, the R on the patient's right side,
 * so that who looks at the patient reads them from left to right.
 */
#ifndef LetteredPhantom_h
#define LetteredPhantom_h

#include "DicomSlices.h"

#include <string>
#include <vector>

struct LetteredPhantom
{
  static constexpr int Size[3] = { 24, 12, 16 };

  /// Where the first voxel is.
  static constexpr double Origin[3] = { -31.0, 17.0, 205.0 };

  static constexpr int Letter = 1000;
  static constexpr int Block = 300;

  /// The value of a voxel: Letter, Block or 0.
  static int At(int x, int y, int z);

  /// Slices whose rows and columns run along these two axes of the patient, or against them.
  static DicomSlices Slices(const Vector& row, const Vector& column);

  struct Cell
  {
    int x;
    int z;
    bool isLetter;
  };

  /// All voxels within the rectangles of the two letters, without their depth.
  static std::vector<Cell> Cells();
};

#endif
