/**
 * @file TestPictures.h
 * @brief Pictures in closed form for the tests of the comparison itself.
 */
#ifndef TestPictures_h
#define TestPictures_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace penumbra
{
/// Each channel of a pixel is the rounded level(x, y, channel).
inline vtkSmartPointer<vtkImageData> MakePicture(
  int width, int height, int channels, const std::function<double(int, int, int)>& level)
{
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(width, height, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, channels);
  auto* out = static_cast<unsigned char*>(picture->GetScalarPointer());
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      for (int channel = 0; channel < channels; ++channel)
      {
        *out++ =
          static_cast<unsigned char>(std::clamp(std::round(level(x, y, channel)), 0.0, 255.0));
      }
    }
  }
  return picture;
}

/// A bright disc on black, `shift` pixels to the right of the middle.
inline vtkSmartPointer<vtkImageData> MakeDisc(int shift = 0)
{
  return MakePicture(64, 48, 3,
    [=](int x, int y, int channel)
    { return std::hypot(x - 32 - shift, y - 24) < 15 ? 240 - 40 * channel : 0; });
}

inline vtkSmartPointer<vtkImageData> MakeBlank(int width = 64, int height = 48, int channels = 3)
{
  return MakePicture(width, height, channels, [](int, int, int) { return 0; });
}
}

#endif
