#include "SliceOrientation.h"

#include "NumberText.h"
#include "VolumeReadingError.h"
#include "vtkMath.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace penumbra
{

namespace
{

// In mm. No detector is as fine or as coarse.
constexpr double SmallestSpacing = 1e-6;
constexpr double LargestSpacing = 1e4;

std::optional<double> UsableSpacing(double spacing)
{
  const bool isUsable = spacing >= SmallestSpacing && spacing <= LargestSpacing;
  return isUsable ? std::optional<double>(spacing) : std::nullopt;
}

void SetPixelSpacing(
  const DicomFrame& frame, SliceOrientation& orientation, std::vector<std::string>& warnings)
{
  const auto& spacing = frame.pixelSpacing;
  const auto rows = spacing ? UsableSpacing((*spacing)[0]) : std::nullopt;
  const auto columns = spacing ? UsableSpacing((*spacing)[1]) : std::nullopt;
  if (!rows || !columns)
  {
    warnings.push_back("the pixel spacing is " +
      (spacing ? NumberText((*spacing)[0]) + " and " + NumberText((*spacing)[1]) + " mm"
               : std::string("not given")) +
      "; 1 mm is taken");
    return;
  }
  if (frame.isSpacingAtDetector)
  {
    warnings.push_back("the pixel spacing of " + NumberText(*rows) + " and " +
      NumberText(*columns) + " mm is that of the detector; the body is smaller");
  }
  orientation.rowSpacing = *rows;
  orientation.columnSpacing = *columns;
}

}

SliceOrientation OrientationOf(const DicomFrame& frame, std::vector<std::string>& warnings)
{
  const std::array<double, 6> axial{ 1.0, 0.0, 0.0, 0.0, 1.0, 0.0 };
  const auto& given = frame.orientation;
  if (!given && frame.position)
  {
    warnings.push_back("the images have no orientation; axial slices are assumed");
  }
  const std::array<double, 6> directions = given.value_or(axial);
  SliceOrientation orientation;
  std::copy_n(directions.begin(), 3, orientation.row.begin());
  std::copy_n(directions.begin() + 3, 3, orientation.column.begin());
  const double rowLength = vtkMath::Normalize(orientation.row.data());
  const double columnLength = vtkMath::Normalize(orientation.column.data());
  const double cosine = vtkMath::Dot(orientation.row.data(), orientation.column.data());
  // Written so that NaN fails as well.
  if (!(std::abs(rowLength - 1.0) < 0.01 && std::abs(columnLength - 1.0) < 0.01 &&
        std::abs(cosine) < 0.01))
  {
    std::string text;
    for (const double value : directions)
    {
      text += (text.empty() ? "" : " ") + NumberText(value);
    }
    throw VolumeReadingError(
      "its Image Orientation (Patient) is " + text + "; two perpendicular unit vectors are needed");
  }
  vtkMath::Cross(orientation.row.data(), orientation.column.data(), orientation.normal.data());
  vtkMath::Normalize(orientation.normal.data());
  vtkMath::Cross(orientation.normal.data(), orientation.row.data(), orientation.column.data());
  SetPixelSpacing(frame, orientation, warnings);
  return orientation;
}

SliceDistance DistanceOf(const DicomFrame& frame, const SliceOrientation& orientation)
{
  const auto usable = [](const std::optional<double>& value)
  { return value ? UsableSpacing(std::abs(*value)) : std::nullopt; };
  if (const auto spacing = usable(frame.spacingBetweenSlices))
  {
    return { *spacing, "Spacing Between Slices" };
  }
  if (const auto thickness = usable(frame.sliceThickness))
  {
    return { *thickness, "Slice Thickness" };
  }
  return { orientation.rowSpacing, "the distance of rows" };
}

}
