#include "Catch.h"
#include "ReadDicom.h"

namespace
{

DicomSlices Inverted(const std::string& modality, bool isSigned = false)
{
  auto slices = Slices(3);
  for (auto& slice : slices)
  {
    slice.elements["Modality"] = modality;
    slice.elements["PhotometricInterpretation"] = "MONOCHROME1";
    slice.bitsStored = 12;
    slice.highBit = 11;
    slice.isSigned = isSigned;
  }
  return slices;
}

DicomReading CheckInverted(const DicomSlices& slices, const ValueOf& valueOf)
{
  const auto parser = GENERATE(from_range(Parsers()));
  const auto reading = ReadSlices(slices, parser);
  CHECK(reading.error == "");
  CHECK(Difference(reading.volume, slices, valueOf) == "");
  CHECK(Mentions(reading.Warnings(), "MONOCHROME1"));
  return reading;
}

}

TEST_CASE("Values without a unit of which small ones are bright are turned over")
{
  CheckInverted(Inverted("MR"), [](const DicomSample&, double stored) { return 4095 - stored; });
}

TEST_CASE("Signed values of which small ones are bright are turned over within their bits")
{
  auto slices = Inverted("MR", true);
  slices[1].stored = [](int i, int, int) { return i == 0 ? -2048 : i == 1 ? 2047 : -i; };
  CheckInverted(slices, [](const DicomSample&, double stored) { return -1 - stored; });
}

TEST_CASE("Values of a unit are kept where small ones are bright")
{
  const auto [modality, keyword, unit] =
    GENERATE(table<std::string, std::string, std::string>({ { "CT", "RescaleIntercept", "0" },
      { "PT", "Units", "BQML" }, { "RTDOSE", "DoseUnits", "GY" } }));
  auto slices = Inverted(modality);
  for (auto& slice : slices)
  {
    slice.elements[keyword] = unit;
  }
  CheckInverted(slices, Stored);
}

TEST_CASE("Values of a rescale type are kept where small ones are bright")
{
  auto slices = Inverted("MR");
  for (auto& slice : slices)
  {
    slice.elements["RescaleType"] = "MGML";
  }
  CheckInverted(slices, Stored);
}

TEST_CASE("Padding among values that are turned over gets the lowest of the others")
{
  auto slices = Inverted("MR");
  for (auto& slice : slices)
  {
    slice.elements["PixelPaddingValue"] = "4095";
    slice.stored = [](int i, int j, int) { return i == 0 ? 4095 : 100 * i + j; };
  }
  CheckInverted(slices,
    [](const DicomSample&, double stored) { return stored == 4095 ? 4095 - 302 : 4095 - stored; });
}
