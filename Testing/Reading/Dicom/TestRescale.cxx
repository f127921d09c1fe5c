#include "Catch.h"
#include "ReadDicom.h"

#include <cmath>

namespace
{

double Rescaled(const DicomSample& slice, double stored)
{
  return std::stod(slice.elements.at("RescaleSlope")) * stored +
    std::stod(slice.elements.at("RescaleIntercept"));
}

void SetRescale(DicomSample& slice, const std::string& slope, const std::string& intercept)
{
  slice.elements["RescaleSlope"] = slope;
  slice.elements["RescaleIntercept"] = intercept;
}

DicomReading CheckRescaled(const DicomSlices& slices)
{
  const auto parser = GENERATE(from_range(Parsers()));
  const auto reading = ReadSlices(slices, parser);
  CHECK(reading.error == "");
  CHECK(Difference(reading.volume, slices, Rescaled) == "");
  return reading;
}

DicomSlices Rescaled(const std::string& slope, const std::string& intercept)
{
  auto slices = Slices(3);
  for (auto& slice : slices)
  {
    SetRescale(slice, slope, intercept);
  }
  return slices;
}

}

TEST_CASE("CT of unsigned values becomes Hounsfield units of 16 signed bits")
{
  auto slices = Rescaled("1", "-1024");
  for (auto& slice : slices)
  {
    slice.bitsStored = 12;
    slice.highBit = 11;
    slice.stored = [](int i, int, int) { return i == 0 ? 4095 : i == 1 ? 0 : 1000; };
  }
  const auto reading = CheckRescaled(slices);
  CHECK(reading.volume->GetScalarType() == VTK_SHORT);
  CHECK(reading.Field("Units") == "HU");
  CHECK(reading.Warnings() == "");
}

TEST_CASE("CT of 16 unsigned bits whose values fit becomes 16 signed bits")
{
  auto slices = Rescaled("1", "-1024");
  for (auto& slice : slices)
  {
    slice.stored = [](int i, int, int) { return i == 0 ? 32767 + 1024 : 0; };
  }
  CHECK(CheckRescaled(slices).volume->GetScalarType() == VTK_SHORT);
}

TEST_CASE("Signed values of 16 bits stay so where the rescaled ones fit")
{
  auto slices = Rescaled("1", "-1024");
  for (auto& slice : slices)
  {
    slice.isSigned = true;
    slice.stored = [](int i, int, int) { return i == 0 ? -32768 + 1024 : 32767; };
  }
  CHECK(CheckRescaled(slices).volume->GetScalarType() == VTK_SHORT);
}

TEST_CASE("Signed values of 16 bits become 32 bits where the rescaled ones do not fit")
{
  auto slices = Rescaled("1", "-1024");
  slices[2].isSigned = slices[1].isSigned = slices[0].isSigned = true;
  slices[1].stored = [](int i, int, int) { return i == 0 ? -32768 + 1023 : 32767; };
  CHECK(CheckRescaled(slices).volume->GetScalarType() == VTK_INT);
}

TEST_CASE("Each slice has its own rescaling")
{
  auto slices = Slices(4);
  SetRescale(slices[0], "0.25", "0");
  SetRescale(slices[1], "1.7309", "-3.25");
  SetRescale(slices[2], "12.5", "0");
  SetRescale(slices[3], "1e-3", "1");
  for (auto& slice : slices)
  {
    slice.elements["Modality"] = "PT";
    slice.elements["Units"] = "BQML";
  }
  const auto reading = CheckRescaled(slices);
  CHECK(reading.volume->GetScalarType() == VTK_FLOAT);
  CHECK(reading.Field("Modality") == "PT");
  CHECK(reading.Field("Units") == "BQML");
}

TEST_CASE("Slices of several whole slopes and intercepts are whole numbers")
{
  auto slices = Slices(3);
  SetRescale(slices[0], "1", "0");
  SetRescale(slices[1], "2", "-100");
  SetRescale(slices[2], "3.0", "1E2");
  const auto reading = CheckRescaled(slices);
  CHECK(reading.volume->GetScalarType() != VTK_FLOAT);
  CHECK(reading.volume->GetScalarType() != VTK_DOUBLE);
}

TEST_CASE("A negative slope turns values")
{
  auto slices = Rescaled("-2", "10");
  CHECK(CheckRescaled(slices).volume->GetScalarType() == VTK_SHORT);
}

TEST_CASE("A slope of parts gives single precision")
{
  auto slices = Rescaled("0.001", "-0.5");
  CHECK(CheckRescaled(slices).volume->GetScalarType() == VTK_FLOAT);
}

TEST_CASE("A slope of parts of more than 24 bits gives double precision")
{
  auto slices = Rescaled("0.001", "-0.5");
  for (auto& slice : slices)
  {
    slice.bitsAllocated = slice.bitsStored = 32;
    slice.highBit = 31;
    slice.stored = [](int i, int j, int) { return 4000000000LL + i + 10 * j; };
  }
  const auto volume = CheckRescaled(slices).volume;
  CHECK(volume->GetScalarType() == VTK_DOUBLE);
  CHECK(std::abs(volume->GetScalarComponentAsDouble(1, 2, 0, 0) - 3999999.521) < 1e-8);
}

TEST_CASE("An intercept without a slope is added, and a slope without an intercept multiplies")
{
  auto slices = Slices(2);
  for (auto& slice : slices)
  {
    slice.elements["RescaleIntercept"] = "-1000";
  }
  CHECK(Difference(ReadSlices(slices).volume, slices,
          [](const DicomSample&, double stored) { return stored - 1000; }) == "");
  for (auto& slice : slices)
  {
    slice.elements.erase("RescaleIntercept");
    slice.elements["RescaleSlope"] = "3";
  }
  CHECK(Difference(ReadSlices(slices).volume, slices,
          [](const DicomSample&, double stored) { return 3 * stored; }) == "");
}

TEST_CASE("The unit is that of the rescale type")
{
  auto slices = Rescaled("0.5", "0");
  for (auto& slice : slices)
  {
    slice.elements["Modality"] = "MR";
    slice.elements["RescaleType"] = "MGML";
  }
  CHECK(ReadSlices(slices).Field("Units") == "MGML");
  for (auto& slice : slices)
  {
    slice.elements.erase("RescaleType");
  }
  CHECK(ReadSlices(slices).Field("Units") == "");
}
