/**
 * @file    StudyPicture.h
 * @brief   pictures as numbers, and how far one is from another
 */

#ifndef StudyPicture_h
#define StudyPicture_h

#include <filesystem>
#include <vector>

namespace penumbra
{

/// Red, green, blue and alpha of each pixel, 0 to 1, bottom row first.
struct StudyPicture
{
  int Width = 0;
  int Height = 0;
  std::vector<float> Values;
};

/// @throw std::runtime_error where the file is no picture of penumbra-render's.
StudyPicture ReadStudyPicture(const std::filesystem::path& file);
void WriteStudyPicture(const StudyPicture& picture, const std::filesystem::path& file);

/// Of red, green and blue, in grey levels of 255.
struct PictureError
{
  double RootMeanSquare = 0.0;
  /// Of the absolute differences.
  double Mean = 0.0;
  double Percentile999 = 0.0;
  double Largest = 0.0;
  /// Mean structural similarity of the luminances (Wang et al. 2004), 1 for equal pictures.
  double StructuralSimilarity = 1.0;
};

/// @throw std::invalid_argument where the pictures' sizes differ.
PictureError CompareWithReference(const StudyPicture& picture, const StudyPicture& reference);

}

#endif
