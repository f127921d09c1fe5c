#include "Catch.h"
#include "ReadDicom.h"

#include <algorithm>

namespace
{

// Three slices twice: those of the second time have other values, and these elements.
void CheckFirstTaken(const DicomElements& first, const DicomElements& second)
{
  const auto parser = GENERATE(from_range(Parsers()));
  DicomSlices taken;
  DicomSlices all;
  for (int number = 0; number < 3; ++number)
  {
    auto slice = Slice(number);
    auto other = Slice(number);
    other.stored = [](int i, int, int) { return 5000 + i; };
    for (const auto& [keyword, value] : first)
    {
      slice.elements[keyword] = value;
    }
    for (const auto& [keyword, value] : second)
    {
      other.elements[keyword] = value;
    }
    taken.push_back(slice);
    all.push_back(other);
    all.push_back(slice);
  }
  const auto reading = ReadSlices(all, parser);
  CHECK(reading.error == "");
  CHECK(Difference(reading.volume, taken) == "");
  CHECK(Mentions(reading.Warnings(), "\\b3\\b"));
}

}

TEST_CASE("Of the images at one position the first by time is taken")
{
  CheckFirstTaken({ { "TemporalPositionIdentifier", "2" }, { "EchoTime", "80" } },
    { { "TemporalPositionIdentifier", "10" }, { "EchoTime", "20" } });
}

TEST_CASE("Of the images at one position the first echo is taken")
{
  CheckFirstTaken({ { "EchoTime", "9.5" }, { "AcquisitionNumber", "2" } },
    { { "EchoTime", "20" }, { "AcquisitionNumber", "1" } });
}

TEST_CASE("Of the images at one position the first acquisition is taken")
{
  CheckFirstTaken({ { "AcquisitionNumber", "2" }, { "InstanceNumber", "9" } },
    { { "AcquisitionNumber", "11" }, { "InstanceNumber", "1" } });
}

TEST_CASE("Of the images at one position the first by instance number is taken")
{
  CheckFirstTaken({ { "InstanceNumber", "9" } }, { { "InstanceNumber", "10" } });
}

TEST_CASE("The same file twice is one slice")
{
  const auto slices = Slices(3);
  auto twice = slices;
  twice.insert(twice.end(), slices.begin(), slices.end());
  const auto reading = ReadSlices(twice);
  CHECK(reading.error == "");
  CHECK(Difference(reading.volume, slices) == "");
}

TEST_CASE("Of images that are all at one position the first is read and the others are told")
{
  auto slices = Slices(4);
  for (auto& slice : slices)
  {
    SetPosition(slice, { 1, 2, 3 });
  }
  std::reverse(slices.begin(), slices.end());
  const auto reading = ReadSlices(slices);
  REQUIRE(reading.error == "");
  CHECK(Difference(reading.volume, { slices.back() }) == "");
  CHECK(Mentions(reading.Warnings(), "\\b3\\b"));
}
