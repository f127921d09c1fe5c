/**
 * @file SampleVolume.h
 * @brief Files of one small volume, and what was read from a file.
 *
 * The sample has 3 x 4 x 5 voxels; voxel (i, j, k) is i + 10 j + 100 k - 200, so that every mistake
 * in the order of axes, slices or bytes shows.
 */
#ifndef SampleVolume_h
#define SampleVolume_h

#include "TemporaryFolder.h"
#include "VolumeFile.h"
#include "vtkImageData.h"

#include <array>
#include <cstring>
#include <filesystem>
#include <string>

using penumbra::TemporaryFolder;

/// The bytes of a value, least or most significant one first.
template <typename Value>
std::string Bytes(Value value, bool bigEndian = false)
{
  std::string bytes(sizeof(Value), '\0');
  std::memcpy(bytes.data(), &value, sizeof(Value));
  const unsigned short one = 1;
  const bool machineIsBigEndian = *reinterpret_cast<const char*>(&one) == 0;
  return bigEndian == machineIsBigEndian ? bytes : std::string(bytes.rbegin(), bytes.rend());
}

/// The sample's voxels as they are in a file.
template <typename Value>
std::string SampleBytes(bool bigEndian = false)
{
  std::string bytes;
  for (int k = 0; k < 5; ++k)
  {
    for (int j = 0; j < 4; ++j)
    {
      for (int i = 0; i < 3; ++i)
      {
        bytes += Bytes(static_cast<Value>(i + 10 * j + 100 * k - 200), bigEndian);
      }
    }
  }
  return bytes;
}

/// The same as text.
std::string SampleText();

/// `bytes` as a gzip or a zlib stream.
std::string Compressed(const std::string& bytes, bool gzip);

vtkSmartPointer<vtkImageData> Read(const std::string& path);

/// Whether the volume has the sample's dimensions and voxels, times `slope` plus `intercept`.
bool IsSample(vtkImageData* image, double slope = 1.0, double intercept = 0.0);

/// Where voxel (i, j, k) is in the world.
std::array<double, 3> PlaceOf(vtkImageData* image, int i, int j, int k);

/// Whether voxel (0, 0, 0) is at `origin` and the steps along the axes lead by these vectors.
bool IsPlaced(vtkImageData* image, const std::array<double, 3>& origin,
  const std::array<std::array<double, 3>, 3>& steps, double tolerance = 1e-6);

/// The message of the VolumeReadingError that reading throws; "was read" where it throws none. A
/// message that is not one line that names the file fails the test.
std::string FailureOf(
  const std::string& path, const std::optional<penumbra::RawVolumeGeometry>& raw = std::nullopt);

#endif
