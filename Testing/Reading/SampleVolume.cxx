#include "SampleVolume.h"

#include "Catch.h"
#include "vtk_zlib.h"

#include <cmath>

std::string SampleText()
{
  std::string text;
  for (int voxel = 0; voxel < 60; ++voxel)
  {
    text += std::to_string(voxel % 3 + 10 * (voxel / 3 % 4) + 100 * (voxel / 12) - 200) +
      (voxel % 7 == 0 ? "\n" : " ");
  }
  return text;
}

std::string Compressed(const std::string& bytes, bool gzip)
{
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, gzip ? 15 + 16 : 15, 8, Z_DEFAULT_STRATEGY);
  std::string input = bytes;
  std::string output(deflateBound(&stream, static_cast<uLong>(bytes.size())) + 64, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(input.data());
  stream.avail_in = static_cast<uInt>(input.size());
  stream.next_out = reinterpret_cast<Bytef*>(output.data());
  stream.avail_out = static_cast<uInt>(output.size());
  deflate(&stream, Z_FINISH);
  output.resize(stream.total_out);
  deflateEnd(&stream);
  return output;
}

vtkSmartPointer<vtkImageData> Read(const std::string& path)
{
  std::vector<std::string> warnings;
  return penumbra::ReadVolumeFile(path, {}, warnings);
}

bool IsSample(vtkImageData* image, double slope, double intercept)
{
  const int* const dimensions = image->GetDimensions();
  if (dimensions[0] != 3 || dimensions[1] != 4 || dimensions[2] != 5)
  {
    return false;
  }
  for (int k = 0; k < 5; ++k)
  {
    for (int j = 0; j < 4; ++j)
    {
      for (int i = 0; i < 3; ++i)
      {
        const double expected = slope * (i + 10 * j + 100 * k - 200) + intercept;
        if (image->GetScalarComponentAsDouble(i, j, k, 0) != expected)
        {
          return false;
        }
      }
    }
  }
  return true;
}

std::array<double, 3> PlaceOf(vtkImageData* image, int i, int j, int k)
{
  std::array<double, 3> place;
  image->TransformIndexToPhysicalPoint(i, j, k, place.data());
  return place;
}

bool IsPlaced(vtkImageData* image, const std::array<double, 3>& origin,
  const std::array<std::array<double, 3>, 3>& steps, double tolerance)
{
  const int index[3] = { 2, 3, 4 };
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto first = PlaceOf(image, 0, 0, 0);
    const auto last =
      PlaceOf(image, axis == 0 ? index[0] : 0, axis == 1 ? index[1] : 0, axis == 2 ? index[2] : 0);
    for (int row = 0; row < 3; ++row)
    {
      const double expected = origin[row] + index[axis] * steps[axis][row];
      if (std::abs(first[row] - origin[row]) > tolerance ||
        std::abs(last[row] - expected) > tolerance)
      {
        return false;
      }
    }
  }
  return true;
}

std::string FailureOf(
  const std::string& path, const std::optional<penumbra::RawVolumeGeometry>& raw)
{
  std::vector<std::string> warnings;
  penumbra::VolumeReadingOptions options;
  options.raw = raw;
  try
  {
    penumbra::ReadVolumeFile(path, options, warnings);
  }
  catch (const penumbra::VolumeReadingError& error)
  {
    const std::string message = error.what();
    CHECK(message.find('\n') == std::string::npos);
    CHECK(message.find(path) != std::string::npos);
    return message;
  }
  return "was read";
}
