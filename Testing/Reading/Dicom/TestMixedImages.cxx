#include "Catch.h"
#include "ReadDicom.h"

namespace
{

// Five slices, and others of their series that must be left out.
void CheckLeftOut(const DicomSlices& others, const std::string& reason)
{
  const auto parser = GENERATE(from_range(Parsers()));
  auto all = others;
  const auto slices = Slices(5);
  all.insert(all.end(), slices.begin(), slices.end());
  const auto reading = ReadSlices(all, parser);
  CHECK(reading.error == "");
  CHECK(Difference(reading.volume, slices) == "");
  CHECK(Mentions(reading.Warnings(), "\\b" + std::to_string(others.size()) + "\\b"));
  CHECK(Mentions(reading.Warnings(), reason));
}

}

TEST_CASE("Images of another orientation than most are left out")
{
  auto others = Slices(2);
  for (auto& slice : others)
  {
    SetOrientation(slice, { 1, 0, 0 }, { 0, 0, -1 });
  }
  CheckLeftOut(others, "orient");
}

TEST_CASE("Images of another size than most are left out")
{
  auto others = Slices(3);
  for (auto& slice : others)
  {
    slice.columns = 8;
  }
  CheckLeftOut(others, "size|columns|pixels");
}

TEST_CASE("Images of another pixel spacing than most are left out")
{
  auto others = Slices(3);
  for (auto& slice : others)
  {
    slice.elements["PixelSpacing"] = "0.75\\0.5";
  }
  CheckLeftOut(others, "spacing");
}

TEST_CASE("Most are those of most images, not those of most pixels")
{
  auto localizer = Slice(0);
  localizer.columns = 40;
  localizer.rows = 30;
  SetOrientation(localizer, { 1, 0, 0 }, { 0, 0, -1 });
  CheckLeftOut({ localizer }, "orient|size|columns");
}

TEST_CASE("An image without pixels or of colour in a series does not matter")
{
  auto report = Slice(1);
  report.hasPixels = false;
  auto colour = Slice(1);
  colour.samplesPerPixel = 3;
  colour.bitsAllocated = colour.bitsStored = 8;
  colour.highBit = 7;
  colour.elements["PhotometricInterpretation"] = "RGB";
  const auto slices = Slices(3);
  DicomSlices all{ report, colour };
  all.insert(all.end(), slices.begin(), slices.end());
  const auto reading = ReadSlices(all);
  CHECK(reading.error == "");
  CHECK(Difference(reading.volume, slices) == "");
}

TEST_CASE("Slices whose values are stored in several ways are one volume")
{
  auto slices = Slices(4);
  slices[0].bitsAllocated = slices[0].bitsStored = 8;
  slices[0].highBit = 7;
  slices[1].bitsStored = 12;
  slices[1].highBit = 11;
  slices[2].isSigned = true;
  const auto reading = ReadSlices(slices);
  CHECK(reading.error == "");
  CHECK(Difference(reading.volume, slices) == "");
}
