#include "Catch.h"
#include "ReadDicom.h"

namespace
{

// Signed slices whose first column is outside the scanner's circle.
DicomSlices PaddedSlices()
{
  auto slices = Slices(3);
  for (int number = 0; number < 3; ++number)
  {
    slices[number].isSigned = true;
    slices[number].elements["PixelPaddingValue"] = "-2000";
    slices[number].stored = [number](int i, int j, int)
    { return i == 0 ? -2000 : -900 + i + 10 * j + 100 * number; };
  }
  return slices;
}

// The lowest of the voxels that are seen.
double Unpadded(const DicomSample&, double stored)
{
  return stored < -1500 ? -899 : stored;
}

void CheckPadded(const DicomSlices& slices, const ValueOf& valueOf = Unpadded)
{
  const auto parser = GENERATE(from_range(Parsers()));
  const auto reading = ReadSlices(slices, parser);
  CHECK(reading.error == "");
  CHECK(Difference(reading.volume, slices, valueOf) == "");
}

}

TEST_CASE("Padding gets the lowest value of all other voxels")
{
  CheckPadded(PaddedSlices());
}

TEST_CASE("Padding that is replaced is told with its count")
{
  const auto warnings = ReadSlices(PaddedSlices()).Warnings();
  CHECK(Mentions(warnings, "padding"));
  CHECK(Mentions(warnings, "\\b9\\b"));
}

TEST_CASE("Padding just below all other values is kept")
{
  auto slices = PaddedSlices();
  const int depth = GENERATE(1, 9);
  for (auto& slice : slices)
  {
    slice.elements["PixelPaddingValue"] = std::to_string(-899 - depth);
    slice.stored = [stored = slice.stored, depth](int i, int j, int k)
    { return i == 0 ? -899 - depth : stored(i, j, k); };
  }
  CheckPadded(slices, Stored);
}

TEST_CASE("All values of the padding range are padding")
{
  auto slices = PaddedSlices();
  const std::string limit = GENERATE("-1990", "-2010");
  for (auto& slice : slices)
  {
    slice.elements["PixelPaddingRangeLimit"] = limit;
    slice.stored = [stored = slice.stored, limit](int i, int j, int k)
    {
      const long long value = stored(i, j, k);
      return value == -2000 ? (limit == "-1990" ? value + 5 * j : value - 5 * j) : value;
    };
  }
  CheckPadded(slices);
}

TEST_CASE("A padding value that is written as unsigned is the signed one of its bits")
{
  auto slices = PaddedSlices();
  for (auto& slice : slices)
  {
    slice.types["PixelPaddingValue"] = gdcm::VR::US;
    slice.elements["PixelPaddingValue"] = std::to_string(65536 - 2000);
  }
  CheckPadded(slices);
}

TEST_CASE("A padding value that is written without a type is read by the pixels'")
{
  auto slices = PaddedSlices();
  for (auto& slice : slices)
  {
    slice.transferSyntax = gdcm::TransferSyntax::ImplicitVRLittleEndian;
  }
  CheckPadded(slices);
}

TEST_CASE("Padding is of the stored values, not the rescaled ones")
{
  auto slices = PaddedSlices();
  for (auto& slice : slices)
  {
    slice.elements["RescaleSlope"] = "2";
    slice.elements["RescaleIntercept"] = "300";
  }
  CheckPadded(slices,
    [](const DicomSample& slice, double stored) { return 2 * Unpadded(slice, stored) + 300; });
}

TEST_CASE("Padding of real values gets the lowest of the others")
{
  auto slices = PaddedSlices();
  for (auto& slice : slices)
  {
    slice.elements["RescaleSlope"] = "0.5";
  }
  CheckPadded(
    slices, [](const DicomSample& slice, double stored) { return 0.5 * Unpadded(slice, stored); });
}

TEST_CASE("Unsigned values have padding too")
{
  auto slices = Slices(3);
  for (int number = 0; number < 3; ++number)
  {
    slices[number].elements["PixelPaddingValue"] = "63536";
    slices[number].stored = [number](int i, int j, int)
    { return i == 0 ? 63536 : 50 + i + 10 * j + 100 * number; };
  }
  CheckPadded(
    slices, [](const DicomSample&, double stored) { return stored == 63536 ? 51 : stored; });
}

TEST_CASE("A padding value that no voxel has changes and tells nothing")
{
  auto slices = Slices(3);
  for (auto& slice : slices)
  {
    slice.elements["PixelPaddingValue"] = "60000";
  }
  const auto reading = ReadSlices(slices);
  CHECK(reading.Warnings() == "");
  CHECK(Difference(reading.volume, slices) == "");
}

TEST_CASE("Each slice has its own padding and rescaling")
{
  auto slices = Slices(3);
  for (int number = 0; number < 3; ++number)
  {
    auto& slice = slices[number];
    slice.elements["PixelPaddingValue"] = std::to_string(3000 + number);
    slice.elements["RescaleIntercept"] = std::to_string(7 * number);
    // The last voxel is no padding, though it has the stored value of another slice's.
    slice.stored = [number](int i, int j, int) {
      return i == 0 ? 3000 + number : i == 3 ? 3000 + (number + 1) % 3 : 10 * j;
    };
  }
  CheckPadded(slices,
    [](const DicomSample& slice, double stored)
    {
      const bool isPadding = std::to_string(int(stored)) == slice.elements.at("PixelPaddingValue");
      return isPadding ? 0 : stored + std::stoi(slice.elements.at("RescaleIntercept"));
    });
}

TEST_CASE("Padding of some slices is none of the others")
{
  const int padded = GENERATE(0, 2);
  auto slices = Slices(3);
  for (auto& slice : slices)
  {
    slice.isSigned = true;
    slice.stored = [](int i, int j, int) { return i == 0 ? -2000 : 10 * i + j; };
  }
  slices[padded].elements["PixelPaddingValue"] = "-2000";
  slices[padded].stored = [](int i, int j, int) { return i == 0 ? -2000 : i == 1 ? -77 : j; };
  CheckPadded(slices,
    [](const DicomSample& slice, double stored)
    {
      const bool isPadding = stored == -2000 && slice.elements.count("PixelPaddingValue") > 0;
      return isPadding ? -2000 : stored;
    });
}

TEST_CASE("Padding is found among 8 bits and in images of many pixels")
{
  const bool isSigned = GENERATE(false, true);
  const int bits = GENERATE(8, 16);
  const int padding = isSigned ? -128 : 255;
  auto slice = Slice(0);
  slice.isSigned = isSigned;
  slice.columns = slice.rows = 260;
  slice.bitsAllocated = slice.bitsStored = bits;
  slice.highBit = bits - 1;
  slice.elements["PixelPaddingValue"] = std::to_string(padding);
  slice.stored = [padding](int i, int j, int) { return i < 9 ? padding : 5 + (i * j) % 100; };
  const auto reading = ReadSlices({ slice });
  CHECK(Difference(reading.volume, { slice },
          [padding](const DicomSample&, double stored)
          { return stored == padding ? 5 : stored; }) == "");
}

TEST_CASE("A volume of nothing but padding is read")
{
  auto slices = Slices(2);
  for (auto& slice : slices)
  {
    slice.elements["PixelPaddingValue"] = "7";
    slice.stored = [](int, int, int) { return 7; };
  }
  const auto reading = ReadSlices(slices);
  CHECK(reading.error == "");
  CHECK(reading.volume->GetScalarRange()[0] == reading.volume->GetScalarRange()[1]);
}

TEST_CASE("Padding does not reach into interpolated slices")
{
  auto slices = PaddedSlices();
  slices.push_back(slices[2]);
  slices.push_back(slices[2]);
  SetPosition(slices[3], { -10, 20, 40 });
  SetPosition(slices[4], { -10, 20, 45 });
  const auto volume = ReadSlices(slices).volume;
  REQUIRE(volume->GetDimensions()[2] == 7);
  for (int k = 0; k < 7; ++k)
  {
    INFO("slice " << k);
    CHECK(volume->GetScalarComponentAsDouble(0, 1, k, 0) == -899);
  }
}
