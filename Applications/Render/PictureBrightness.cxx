#include "PictureBrightness.h"

#include "Picture.h"

#include <vtkImageData.h>

#include <algorithm>

namespace penumbra
{
namespace
{
constexpr double LeastAlpha = 0.03;
constexpr double BurntOutFrom = 0.995;
constexpr double BlackBelow = 0.05;
}

//------------------------------------------------------------------------------
PictureBrightness MeasureBrightness(vtkImageData* picture)
{
  const vtkIdType pixels = picture->GetNumberOfPoints();
  const auto bytes = ToBytes(picture);
  const auto* levels = static_cast<const unsigned char*>(bytes->GetScalarPointer());
  PictureBrightness brightness;
  double covered = 0.0;
  for (vtkIdType pixel = 0; pixel < pixels; ++pixel, levels += 4)
  {
    if (levels[3] <= 255.0 * LeastAlpha)
    {
      continue;
    }
    const double luminance = (0.2126 * levels[0] + 0.7152 * levels[1] + 0.0722 * levels[2]) / 255.0;
    const double highest = std::max({ levels[0], levels[1], levels[2] }) / 255.0;
    covered += 1.0;
    brightness.Luminance += luminance;
    brightness.BurntOut += highest >= BurntOutFrom ? 1.0 : 0.0;
    brightness.Black += luminance < BlackBelow ? 1.0 : 0.0;
  }
  if (covered > 0.0)
  {
    brightness.Foreground = covered / static_cast<double>(pixels);
    brightness.Luminance /= covered;
    brightness.BurntOut /= covered;
    brightness.Black /= covered;
  }
  return brightness;
}

}
