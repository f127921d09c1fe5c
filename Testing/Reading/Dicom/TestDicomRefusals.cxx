#include "Catch.h"
#include "ReadDicom.h"

#include "vtkNew.h"

namespace
{

// The image alone, as a file and in a folder, is refused by its name and for this reason.
void CheckRefused(const DicomSample& image, const std::string& reason)
{
  const auto parser = GENERATE(from_range(Parsers()));
  const TemporaryFolder folder;
  const auto file = folder.Write("inner/image.dcm", image.File());
  for (const auto& path : { file, folder.PathOf("inner") })
  {
    const auto error = ReadDicom(path, parser).error;
    INFO(error);
    CHECK(Mentions(error, reason));
    CHECK(Mentions(error, "inner"));
    CHECK(error.size() < 1000);
  }
  CHECK(Mentions(ReadDicom(file, parser).error, "image\\.dcm"));
}

DicomSample ByteImage(const std::string& interpretation, int samplesPerPixel)
{
  auto image = Slice(0);
  image.samplesPerPixel = samplesPerPixel;
  image.bitsAllocated = image.bitsStored = 8;
  image.highBit = 7;
  image.elements["PhotometricInterpretation"] = interpretation;
  return image;
}

void CheckRefusedPath(const std::string& path, const std::string& name)
{
  for (const auto& parser : Parsers())
  {
    const auto error = ReadDicom(path, parser).error;
    INFO(error);
    CHECK(error.find(name) != std::string::npos);
  }
}

}

TEST_CASE("Colour images are refused")
{
  const std::string interpretation = GENERATE("RGB", "YBR_FULL");
  CheckRefused(ByteImage(interpretation, 3), "colou?r");
}

TEST_CASE("Images of a colour palette are refused")
{
  auto image = ByteImage("PALETTE COLOR", 1);
  for (const std::string colour : { "Red", "Green", "Blue" })
  {
    image.elements[colour + "PaletteColorLookupTableDescriptor"] = "1\\0\\16";
    image.elements[colour + "PaletteColorLookupTableData"] = "0";
    image.types[colour + "PaletteColorLookupTableDescriptor"] = gdcm::VR::US;
    image.types[colour + "PaletteColorLookupTableData"] = gdcm::VR::US;
  }
  CheckRefused(image, "colou?r");
}

TEST_CASE("Segmentations of one bit are refused")
{
  auto image = Slice(0);
  image.elements["SOPClassUID"] = "1.2.840.10008.5.1.4.1.1.66.4";
  image.elements["Modality"] = "SEG";
  image.bitsAllocated = image.bitsStored = 1;
  image.highBit = 0;
  image.columns = 16;
  image.stored = [](int i, int, int) { return i % 2; };
  CheckRefused(image, "\\bbit");
}

TEST_CASE("Reports are refused")
{
  auto report = UnplacedImage();
  report.elements["SOPClassUID"] = "1.2.840.10008.5.1.4.1.1.88.11";
  report.elements["Modality"] = "SR";
  report.hasPixels = false;
  CheckRefused(report, "pixel|image");
}

TEST_CASE("Mosaics are refused")
{
  auto image = Slice(0);
  image.elements["Modality"] = "MR";
  image.elements["ImageType"] = "ORIGINAL\\PRIMARY\\M\\ND\\MOSAIC";
  CheckRefused(image, "mosaic");
}

TEST_CASE("Orientations that are none are refused")
{
  const std::string orientation = GENERATE("0\\0\\0\\0\\0\\0", "1\\0\\0\\1\\0\\0",
    "1\\0\\0\\-1\\0\\0", "1\\0\\0\\0\\0\\0", "1\\0\\0\\1\\1\\0");
  auto image = Slice(0);
  image.elements["ImageOrientationPatient"] = orientation;
  CheckRefused(image, "orientation");
}

TEST_CASE("A pixel spacing that is none is told, or the image refused")
{
  const std::string spacing = GENERATE("0\\0.75", "0.5\\-0.75", "0\\0", "0.5\\1e300", "abc");
  auto image = Slice(0);
  image.elements["PixelSpacing"] = spacing;
  for (const auto& parser : Parsers())
  {
    const auto reading = ReadSlices({ image }, parser);
    CHECK(Mentions(reading.error + reading.Warnings(), "spacing"));
  }
}

TEST_CASE("Images without rows or columns are refused")
{
  const std::string keyword = GENERATE("Rows", "Columns");
  auto image = Slice(0);
  image.elements[keyword] = "0";
  CheckRefused(image, "row|column|size|pixel");
}

TEST_CASE("An image that has fewer pixels than it says is refused")
{
  auto image = Slice(0);
  image.elements["Rows"] = "60000";
  image.elements["Columns"] = "60000";
  CheckRefused(image, "pixel|bytes|memory|short");
}

TEST_CASE("Folders without an image are refused")
{
  const TemporaryFolder folder;
  CheckRefusedPath(folder.PathOf(""), "penumbra ");
  folder.Write("notes/a.txt", "no image");
  folder.Write("notes/b.png", "\x89PNG\r\n\x1a\n");
  CheckRefusedPath(folder.PathOf("notes"), folder.PathOf("notes"));
}

TEST_CASE("Missing, empty and other files are refused")
{
  const TemporaryFolder folder;
  CheckRefusedPath(folder.PathOf("missing.dcm"), "missing.dcm");
  CheckRefusedPath(folder.Write("empty.dcm", ""), "empty.dcm");
  CheckRefusedPath(folder.Write("text.dcm", std::string(2000, 'x')), "text.dcm");
  CheckRefusedPath(folder.Write("line\nfeed.dcm", "x"), "feed.dcm");
}

TEST_CASE("A file cut short at any byte is refused")
{
  const TemporaryFolder folder;
  const auto file = Slice(3).File();
  for (std::size_t size = 0; size < file.size(); size += 7)
  {
    INFO(size << " of " << file.size() << " bytes");
    const auto path = folder.Write("cut.dcm", file.substr(0, size));
    CHECK(Mentions(ReadDicom(path, PENUMBRA_DICOM_PARSER).error, "cut\\.dcm"));
  }
}

TEST_CASE("A reader without a name refuses")
{
  vtkNew<vtkDICOMVolumeReader> reader;
  CHECK(Update(reader).error != "");
}

TEST_CASE("A reader goes on after an error")
{
  const auto parser = GENERATE(from_range(Parsers()));
  const TemporaryFolder folder;
  WriteSlices(folder, Slices(3), "good/");
  vtkNew<vtkDICOMVolumeReader> reader;
  reader->SetParserProgram(parser.c_str());
  for (int round = 0; round < 2; ++round)
  {
    reader->SetFileName(folder.PathOf("missing").c_str());
    CHECK(Update(reader).error != "");
    reader->SetFileName(folder.PathOf("good").c_str());
    const auto reading = Update(reader);
    CHECK(reading.error == "");
    CHECK(reading.Warnings() == "");
    CHECK(Difference(reading.volume, Slices(3)) == "");
  }
}
