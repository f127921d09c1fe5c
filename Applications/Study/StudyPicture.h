/**
 * @file    StudyPicture.h
 * @brief   pictures as numbers, and how far one is from another
 */

#ifndef StudyPicture_h
#define StudyPicture_h

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <vector>

class vtkImageData;

namespace penumbra
{

/// Red, green, blue and alpha of each pixel, 0 to 1, bottom row first.
struct StudyPicture
{
  int Width = 0;
  int Height = 0;
  std::vector<float> Values;
};

/// Of a window's picture: RGBA in 8 bits.
StudyPicture ToStudyPicture(vtkImageData* picture);

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

/// The part of all pixels, 0 to 1, that differ by more than a grey level of 255 in red, green or
/// blue. @throw std::invalid_argument where the pictures' sizes differ.
double PartThatDiffers(const StudyPicture& picture, const StudyPicture& other);

/// As studies keep it.
///@{
void to_json(nlohmann::json& json, const PictureError& error);
void from_json(const nlohmann::json& json, PictureError& error);
///@}

}

#endif
