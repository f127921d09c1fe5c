#include "Catch.h"
#include "ReadDicom.h"

namespace
{

const std::vector<int> Order = { 3, 0, 4, 1, 2 };

// The sample's slices as the frames of one image, in another order.
DicomSample EnhancedImage()
{
  auto image = UnplacedImage();
  image.elements["SOPClassUID"] = "1.2.840.10008.5.1.4.1.1.2.1";
  image.frames = static_cast<int>(Order.size());
  image.sharedGroups["PixelMeasuresSequence"] = { { "PixelSpacing", "0.5\\0.75" },
    { "SliceThickness", "2" } };
  image.sharedGroups["PlaneOrientationSequence"] = { { "ImageOrientationPatient",
    "1\\0\\0\\0\\1\\0" } };
  image.stored = [](int i, int j, int k) { return Slice(Order[k]).stored(i, j, 0); };
  for (const int number : Order)
  {
    image.frameGroups.push_back({ { "PlanePositionSequence",
      { { "ImagePositionPatient", Slice(number).elements.at("ImagePositionPatient") } } } });
  }
  return image;
}

DicomReading ReadImage(const DicomSample& image)
{
  const auto parser = GENERATE(from_range(Parsers()));
  const TemporaryFolder folder;
  return ReadDicom(folder.Write("image.dcm", image.File()), parser);
}

double ValueAt(const DicomReading& reading, int i, int j, int k)
{
  return reading.volume->GetScalarComponentAsDouble(i, j, k, 0);
}

}

TEST_CASE("The frames of an enhanced image lie where their groups say")
{
  const auto reading = ReadImage(EnhancedImage());
  CHECK(reading.error == "");
  CHECK(reading.Warnings() == "");
  CHECK(Difference(reading.volume, Slices(5)) == "");
}

TEST_CASE("Each frame of an enhanced image has its own rescaling")
{
  auto image = EnhancedImage();
  for (int frame = 0; frame < image.frames; ++frame)
  {
    image.frameGroups[frame]["PixelValueTransformationSequence"] = {
      { "RescaleSlope", Text({ 0.5 + Order[frame] }) },
      { "RescaleIntercept", Text({ -10.0 * Order[frame] }) }, { "RescaleType", "HU" }
    };
  }
  const auto reading = ReadImage(image);
  CHECK(reading.volume->GetScalarType() == VTK_FLOAT);
  CHECK(reading.Field("Units") == "HU");
  const auto valueOf = [](const DicomSample& slice, double stored)
  {
    const int number = std::stoi(slice.elements.at("InstanceNumber")) - 1;
    return (0.5 + number) * stored - 10 * number;
  };
  CHECK(Difference(reading.volume, Slices(5), valueOf) == "");
}

TEST_CASE("Orientation and spacing may be those of each frame")
{
  auto image = EnhancedImage();
  for (auto& groups : image.frameGroups)
  {
    groups.insert(image.sharedGroups.begin(), image.sharedGroups.end());
  }
  image.sharedGroups.clear();
  CHECK(Difference(ReadImage(image).volume, Slices(5)) == "");
}

TEST_CASE("Several enhanced images of a series are one volume")
{
  const TemporaryFolder folder;
  auto first = EnhancedImage();
  auto second = EnhancedImage();
  first.frameGroups.resize(2);
  first.frames = 2;
  second.frameGroups.erase(second.frameGroups.begin(), second.frameGroups.begin() + 2);
  second.frames = 3;
  second.stored = [](int i, int j, int k) { return Slice(Order[k + 2]).stored(i, j, 0); };
  folder.Write("a", first.File());
  folder.Write("b", second.File());
  CHECK(Difference(ReadDicom(folder.PathOf("")).volume, Slices(5)) == "");
}

TEST_CASE("Of the frames at one position the first in time is taken")
{
  auto image = EnhancedImage();
  image.frames = 10;
  image.stored = [](int i, int j, int k)
  { return Slice(Order[k % 5]).stored(i, j, 0) + (k < 5 ? 4000 : 0); };
  const auto groups = image.frameGroups;
  image.frameGroups.insert(image.frameGroups.end(), groups.begin(), groups.end());
  for (int frame = 0; frame < 10; ++frame)
  {
    image.frameGroups[frame]["FrameContentSequence"] = { { "TemporalPositionIndex",
      frame < 5 ? "2" : "1" } };
  }
  const auto reading = ReadImage(image);
  CHECK(reading.error == "");
  CHECK(Difference(reading.volume, Slices(5)) == "");
  CHECK(Mentions(reading.Warnings(), "\\b5\\b"));
}

TEST_CASE("Frames without a position become slices in their order, which is told")
{
  auto image = UnplacedImage();
  image.elements["SOPClassUID"] = "1.2.840.10008.5.1.4.1.1.7.3";
  image.elements["Modality"] = "OT";
  image.frames = 6;
  const auto reading = ReadImage(image);
  REQUIRE(reading.error == "");
  REQUIRE(reading.volume->GetDimensions()[2] == 6);
  CHECK(reading.warnings.size() > 0);
  for (int k = 0; k < 6; ++k)
  {
    CHECK(ValueAt(reading, 3, 2, k) == 23 + 100 * k);
  }
  CHECK(reading.volume->GetSpacing()[0] == 1.0);
  CHECK(reading.volume->GetSpacing()[2] == 1.0);
}

TEST_CASE("Frames that are moments in time are refused")
{
  auto image = UnplacedImage();
  image.elements["SOPClassUID"] = "1.2.840.10008.5.1.4.1.1.12.1";
  image.elements["Modality"] = "XA";
  image.elements["FrameTime"] = "40";
  image.elements["FrameIncrementPointer"] = "0018,1063";
  image.frames = 6;
  CHECK(Mentions(ReadImage(image).error, "image\\.dcm.*time"));
}

TEST_CASE("Frames of unequal times are refused")
{
  auto image = UnplacedImage();
  image.elements["Modality"] = "US";
  image.elements["FrameTimeVector"] = "0\\40\\41";
  image.elements["FrameIncrementPointer"] = "0018,1065";
  image.frames = 3;
  CHECK(Mentions(ReadImage(image).error, "image\\.dcm.*time"));
}

TEST_CASE("The frames of a nuclear tomogram lie along the normal of its detector")
{
  auto image = UnplacedImage();
  image.elements["SOPClassUID"] = "1.2.840.10008.5.1.4.1.1.20";
  image.elements["Modality"] = "NM";
  image.elements["FrameIncrementPointer"] = "0054,0080";
  image.elements["SliceVector"] = "1\\2\\3\\4\\5";
  image.elements["PixelSpacing"] = "0.5\\0.75";
  image.elements["SliceThickness"] = "2";
  image.elements["SpacingBetweenSlices"] = "2.5";
  image.sequences["DetectorInformationSequence"] = {
    { "ImagePositionPatient", Slice(0).elements.at("ImagePositionPatient") },
    { "ImageOrientationPatient", Slice(0).elements.at("ImageOrientationPatient") }
  };
  image.frames = 5;
  image.stored = [](int i, int j, int k) { return Slice(k).stored(i, j, 0); };
  const auto reading = ReadImage(image);
  CHECK(reading.error == "");
  CHECK(Difference(reading.volume, Slices(5)) == "");
}

TEST_CASE("A series of enhanced images of one frame is one volume")
{
  const TemporaryFolder folder;
  for (int number = 0; number < 5; ++number)
  {
    auto image = UnplacedImage();
    image.elements["NumberOfFrames"] = "1";
    image.sharedGroups = EnhancedImage().sharedGroups;
    image.frameGroups = { { { "PlanePositionSequence",
      { { "ImagePositionPatient", Slice(number).elements.at("ImagePositionPatient") } } } } };
    image.stored = Slice(number).stored;
    folder.Write(std::to_string(9 - number), image.File());
  }
  CHECK(Difference(ReadDicom(folder.PathOf("")).volume, Slices(5)) == "");
}
