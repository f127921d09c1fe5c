/**
 * @file ImageComparison.h
 * @brief How far two pictures differ, and whether a picture is still what its baseline shows.
 *
 * Pictures are vtkImageData of 8-bit RGB or RGBA.
 */
#ifndef ImageComparison_h
#define ImageComparison_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>

namespace penumbra
{
struct ImageDifference
{
  /// Root mean square over all pixels and channels, in grey levels of 255.
  double rmse = 0.0;
  /// Of any channel of any pixel, in grey levels of 255.
  double largest = 0.0;
  /**
   * Mean structural similarity of the luminances, 1 for equal pictures: Wang, Bovik, Sheikh and
   * Simoncelli, "Image quality assessment: from error visibility to structural similarity", IEEE
   * Transactions on Image Processing 13(4), 2004, with their 11x11 Gaussian window of standard
   * deviation 1.5, K1 = 0.01, K2 = 0.03. Windows at the border are cut off and renormalised.
   */
  double ssim = 1.0;
};

/// @throw std::invalid_argument where the pictures' sizes, channels or types do not allow it.
ImageDifference CompareImages(vtkImageData* picture, vtkImageData* baseline);

/// The absolute difference of every channel, stretched until the largest is 255; opaque RGB.
vtkSmartPointer<vtkImageData> DifferenceImage(vtkImageData* picture, vtkImageData* baseline);

/// @throw std::runtime_error naming the file where that fails.
vtkSmartPointer<vtkImageData> ReadPNG(const std::string& file);
void WritePNG(vtkImageData* picture, const std::string& file);

struct ComparisonThresholds
{
  double maxRmse;
  double minSsim;
};

/// Where baselines are, and where a failing test leaves its picture.
struct BaselineFolders
{
  std::string baselines;
  std::string failures;

  /// Testing/Baselines of the sources and Testing/Failures of the build.
  static BaselineFolders OfProject();
};

/**
 * Whether the picture is within the thresholds of the baseline NAME.png. Where it is not, or where
 * there is no such baseline, says so, and leaves NAME.png and NAME-difference.png among the
 * failures.
 */
bool CompareWithBaseline(vtkImageData* picture, const std::string& name,
  const ComparisonThresholds& thresholds,
  const BaselineFolders& folders = BaselineFolders::OfProject());
}

#endif
