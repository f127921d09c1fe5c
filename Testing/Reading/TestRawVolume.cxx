#include "Catch.h"
#include "SampleVolume.h"

#include <cmath>
#include <limits>

using Catch::Matchers::ContainsSubstring;

namespace
{

penumbra::RawVolumeGeometry SampleGeometry(int scalarType)
{
  penumbra::RawVolumeGeometry geometry;
  geometry.dimensions[0] = 3;
  geometry.dimensions[1] = 4;
  geometry.dimensions[2] = 5;
  geometry.scalarType = scalarType;
  return geometry;
}

vtkSmartPointer<vtkImageData> ReadRaw(
  const std::string& path, const penumbra::RawVolumeGeometry& geometry)
{
  std::vector<std::string> warnings;
  penumbra::VolumeReadingOptions options;
  options.raw = geometry;
  return penumbra::ReadVolumeFile(path, options, warnings);
}

template <typename Value>
void CheckType(int scalarType)
{
  const TemporaryFolder folder;
  for (const bool bigEndian : { false, true })
  {
    INFO(penumbra::ScalarTypeName(scalarType) << (bigEndian ? " big" : " little"));
    auto geometry = SampleGeometry(scalarType);
    geometry.bigEndian = bigEndian;
    geometry.headerBytes = 7;
    const auto path = folder.Write("a.raw", "header " + SampleBytes<Value>(bigEndian));
    const auto image = ReadRaw(path, geometry);
    CHECK(image->GetScalarType() == scalarType);
    for (int voxel = 0; voxel < 60; ++voxel)
    {
      const int i = voxel % 3, j = voxel / 3 % 4, k = voxel / 12;
      const double expected = static_cast<double>(static_cast<Value>(i + 10 * j + 100 * k - 200));
      REQUIRE(image->GetScalarComponentAsDouble(i, j, k, 0) == expected);
    }
  }
}

}

TEST_CASE("RAW voxels of every type and byte order keep their values")
{
  CheckType<signed char>(VTK_SIGNED_CHAR);
  CheckType<unsigned char>(VTK_UNSIGNED_CHAR);
  CheckType<short>(VTK_SHORT);
  CheckType<unsigned short>(VTK_UNSIGNED_SHORT);
  CheckType<int>(VTK_INT);
  CheckType<float>(VTK_FLOAT);
  CheckType<double>(VTK_DOUBLE);
  const TemporaryFolder folder;
  auto geometry = SampleGeometry(VTK_UNSIGNED_INT);
  geometry.dimensions[0] = geometry.dimensions[1] = geometry.dimensions[2] = 1;
  const auto path = folder.Write("a.RAW", Bytes<unsigned int>(4000000000u));
  CHECK(ReadRaw(path, geometry)->GetScalarComponentAsDouble(0, 0, 0, 0) == 4000000000.0);
}

TEST_CASE("RAW volumes lie where they are said to, mirrored ones too")
{
  const TemporaryFolder folder;
  auto geometry = SampleGeometry(VTK_SHORT);
  const double direction[9] = { 0, 1, 0, 1, 0, 0, 0, 0, 1 };
  std::copy_n(direction, 9, geometry.direction);
  geometry.spacing[0] = 2.0;
  geometry.spacing[1] = 3.0;
  geometry.spacing[2] = 0.5;
  geometry.origin[1] = -7.0;
  const auto image = ReadRaw(folder.Write("a.raw", SampleBytes<short>()), geometry);
  CHECK(IsSample(image));
  CHECK(IsPlaced(image, { 0, -7, 0 }, { { { 0, 2, 0 }, { 3, 0, 0 }, { 0, 0, 0.5 } } }));
}

TEST_CASE("RAW voxels that are not finite stay as they are")
{
  const TemporaryFolder folder;
  auto geometry = SampleGeometry(VTK_FLOAT);
  geometry.dimensions[0] = 3;
  geometry.dimensions[1] = geometry.dimensions[2] = 1;
  const float infinity = std::numeric_limits<float>::infinity();
  const auto path =
    folder.Write("a.raw", Bytes(std::nanf("")) + Bytes(infinity) + Bytes(-infinity));
  const auto image = ReadRaw(path, geometry);
  CHECK(std::isnan(image->GetScalarComponentAsDouble(0, 0, 0, 0)));
  CHECK(image->GetScalarComponentAsDouble(1, 0, 0, 0) == infinity);
  CHECK(image->GetScalarComponentAsDouble(2, 0, 0, 0) == -infinity);
}

TEST_CASE("RAW files of another size than stated are refused with both sizes")
{
  const TemporaryFolder folder;
  auto geometry = SampleGeometry(VTK_SHORT);
  for (const int size : { 1, 119, 121, 240 })
  {
    INFO(size);
    const auto failure = FailureOf(folder.Write("a.raw", std::string(size, 'a')), geometry);
    CHECK_THAT(failure, ContainsSubstring("holds " + std::to_string(size) + " bytes"));
    CHECK_THAT(failure, ContainsSubstring("need exactly 120 bytes"));
  }
  const auto path = folder.Write("a.raw", SampleBytes<short>());
  for (const std::uint64_t headerBytes :
    { std::uint64_t(1), std::uint64_t(120), std::numeric_limits<std::uint64_t>::max() })
  {
    geometry.headerBytes = headerBytes;
    CHECK_THAT(FailureOf(path, geometry), ContainsSubstring("need exactly"));
  }
  CHECK_THAT(FailureOf(path), ContainsSubstring("dimensions"));
}
