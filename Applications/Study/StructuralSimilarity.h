/**
 * @file StructuralSimilarity.h
 * @brief The structural similarity of two grey pictures; ImageComparison.h says which.
 */
#ifndef StructuralSimilarity_h
#define StructuralSimilarity_h

#include <vector>

namespace penumbra
{
/// Grey levels of 255, row by row.
struct GreyPicture
{
  int width = 0;
  int height = 0;
  std::vector<double> levels;
};

/// The mean over all pixels; both pictures have the same size, at least one pixel.
double StructuralSimilarity(const GreyPicture& a, const GreyPicture& b);
}

#endif
