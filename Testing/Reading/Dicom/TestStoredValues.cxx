#include "Catch.h"
#include "ReadDicom.h"

#include <algorithm>
#include <cmath>

namespace
{

struct Storage
{
  int bitsAllocated;
  int bitsStored;
  int highBit;
  bool isSigned;
};

long long Lowest(const Storage& storage)
{
  return storage.isSigned ? -(1LL << (storage.bitsStored - 1)) : 0;
}

long long Highest(const Storage& storage)
{
  return Lowest(storage) + (1LL << storage.bitsStored) - 1;
}

// Both extremes in each slice, and all bits in use between.
DicomSlices SlicesOf(const Storage& storage)
{
  auto slices = Slices(3);
  for (int number = 0; number < 3; ++number)
  {
    auto& slice = slices[number];
    slice.bitsAllocated = storage.bitsAllocated;
    slice.bitsStored = storage.bitsStored;
    slice.highBit = storage.highBit;
    slice.isSigned = storage.isSigned;
    slice.stored = [storage, number](int i, int j, int) -> long long
    {
      const double share = std::fmod((i + 4 * j + 12 * number) * 0.61803398875, 1.0);
      const double range = static_cast<double>(Highest(storage) - Lowest(storage));
      return i == 0 ? (j == 0 ? Lowest(storage) : Highest(storage))
                    : Lowest(storage) + static_cast<long long>(share * range);
    };
  }
  return slices;
}

vtkSmartPointer<vtkImageData> CheckStorage(const Storage& storage, bool unusedBits = false)
{
  auto slices = SlicesOf(storage);
  for (auto& slice : slices)
  {
    slice.unusedBits = unusedBits;
  }
  const auto parser = GENERATE(from_range(Parsers()));
  const auto reading = ReadSlices(slices, parser);
  CHECK(reading.error == "");
  CHECK(reading.Warnings() == "");
  CHECK(Difference(reading.volume, slices) == "");
  return reading.volume;
}

}

TEST_CASE("Unsigned values of 8 bits are read")
{
  CHECK(CheckStorage({ 8, 8, 7, false })->GetScalarType() == VTK_UNSIGNED_CHAR);
}

TEST_CASE("Signed values of 8 bits are read")
{
  CHECK(CheckStorage({ 8, 8, 7, true })->GetScalarType() == VTK_SIGNED_CHAR);
}

TEST_CASE("Unsigned values of 16 bits are read")
{
  CHECK(CheckStorage({ 16, 16, 15, false })->GetScalarType() == VTK_UNSIGNED_SHORT);
}

TEST_CASE("Signed values of 16 bits are read")
{
  CHECK(CheckStorage({ 16, 16, 15, true })->GetScalarType() == VTK_SHORT);
}

TEST_CASE("Unsigned values of 32 bits are read")
{
  CHECK(CheckStorage({ 32, 32, 31, false })->GetScalarType() == VTK_UNSIGNED_INT);
}

TEST_CASE("Signed values of 32 bits are read")
{
  CHECK(CheckStorage({ 32, 32, 31, true })->GetScalarType() == VTK_INT);
}

TEST_CASE("Unsigned values of 12 of 16 bits are read")
{
  const bool unusedBits = GENERATE(false, true);
  CheckStorage({ 16, 12, 11, false }, unusedBits);
}

TEST_CASE("Signed values of 12 of 16 bits are read")
{
  const bool unusedBits = GENERATE(false, true);
  CHECK(CheckStorage({ 16, 12, 11, true }, unusedBits)->GetScalarType() == VTK_SHORT);
}

TEST_CASE("Values whose highest bit is not that of their count are read")
{
  const bool isSigned = GENERATE(false, true);
  const bool unusedBits = GENERATE(false, true);
  CheckStorage({ 16, 12, 15, isSigned }, unusedBits);
}

TEST_CASE("Values of 10 bits in the middle of 16 are read")
{
  const bool isSigned = GENERATE(false, true);
  CheckStorage({ 16, 10, 12, isSigned }, true);
}

TEST_CASE("Values of 6 of 8 bits are read")
{
  const bool isSigned = GENERATE(false, true);
  const bool unusedBits = GENERATE(false, true);
  CheckStorage({ 8, 6, 5, isSigned }, unusedBits);
}

TEST_CASE("Values of 20 of 32 bits are read")
{
  const bool isSigned = GENERATE(false, true);
  const bool unusedBits = GENERATE(false, true);
  CheckStorage({ 32, 20, 19, isSigned }, unusedBits);
}

TEST_CASE("Images of more pixels than there are values are read")
{
  const auto storage = GENERATE(values<Storage>({ { 8, 8, 7, false }, { 8, 8, 7, true },
    { 16, 16, 15, false }, { 16, 16, 15, true }, { 16, 12, 11, false }, { 16, 12, 11, true } }));
  const bool unusedBits = GENERATE(false, true);
  auto slice = SlicesOf(storage)[1];
  slice.unusedBits = unusedBits;
  slice.columns = 300;
  slice.rows = 250;
  slice.elements["RescaleSlope"] = "-2";
  slice.elements["RescaleIntercept"] = "3";
  const auto reading = ReadSlices({ slice });
  CHECK(reading.error == "");
  CHECK(Difference(reading.volume, { slice },
          [](const DicomSample&, double stored) { return 3 - 2 * stored; }) == "");
}
