#include "Catch.h"
#include "ReadDicom.h"

namespace
{

// The planes of a dose.
DicomSample Dose(const std::string& offsets)
{
  auto dose = Slice(0);
  dose.elements["SOPClassUID"] = "1.2.840.10008.5.1.4.1.1.481.2";
  dose.elements["Modality"] = "RTDOSE";
  dose.elements["DoseUnits"] = "GY";
  dose.elements["DoseGridScaling"] = "0.0125";
  dose.elements["FrameIncrementPointer"] = "3004,000c";
  dose.elements["GridFrameOffsetVector"] = offsets;
  dose.elements["SliceThickness"] = "";
  dose.frames = static_cast<int>(Numbers(offsets).size());
  dose.bitsAllocated = dose.bitsStored = 32;
  dose.highBit = 31;
  dose.stored = [](int i, int j, int k) { return 70000LL * (k + 1) * (k + 1) + i + 10 * j; };
  return dose;
}

DicomSlices Planes(const DicomSample& dose, const std::vector<double>& heights)
{
  DicomSlices planes;
  for (int k = 0; k < dose.frames; ++k)
  {
    planes.push_back(dose);
    SetPosition(planes.back(), { -10, 20, heights[k] });
    planes.back().stored = [dose, k](int i, int j, int) { return dose.stored(i, j, k); };
  }
  return planes;
}

void CheckDose(const DicomSample& dose, const std::vector<double>& heights)
{
  const auto parser = GENERATE(from_range(Parsers()));
  const TemporaryFolder folder;
  const auto reading = ReadDicom(folder.Write("dose", dose.File()), parser);
  CHECK(reading.error == "");
  CHECK(reading.Warnings() == "");
  CHECK(reading.Field("Modality") == "RTDOSE");
  CHECK(Mentions(reading.Field("Units"), "^GY$"));
  CHECK(Difference(reading.volume, Planes(dose, heights),
          [](const DicomSample&, double stored) { return 0.0125 * stored; }) == "");
}

}

TEST_CASE("The planes of a dose lie at their offsets")
{
  CheckDose(Dose("0\\5\\10\\15"), { 30, 35, 40, 45 });
}

TEST_CASE("The planes of a dose may descend")
{
  CheckDose(Dose("0\\-5\\-10\\-15"), { 30, 25, 20, 15 });
}

TEST_CASE("The planes of a dose may have no order")
{
  CheckDose(Dose("0\\10\\5\\-5"), { 30, 40, 35, 25 });
}

TEST_CASE("The offsets of a dose may be patient coordinates")
{
  CheckDose(Dose("30\\35\\40\\45"), { 30, 35, 40, 45 });
}

TEST_CASE("Unevenly spaced planes of a dose are told")
{
  const TemporaryFolder folder;
  const auto reading = ReadDicom(folder.Write("dose", Dose("0\\5\\10\\25").File()));
  CHECK(reading.error == "");
  CHECK(reading.volume->GetDimensions()[2] == 6);
  CHECK(Mentions(reading.Warnings(), "\\b2\\b"));
}

TEST_CASE("A dose may have hundreds of planes")
{
  std::vector<double> offsets;
  std::vector<double> heights;
  for (int plane = 0; plane < 300; ++plane)
  {
    offsets.push_back(2.5 * plane);
    heights.push_back(30 + offsets.back());
  }
  auto dose = Dose(Text(offsets));
  dose.stored = [](int i, int j, int k) { return 70000LL * k + i + 10 * j; };
  CheckDose(dose, heights);
}
