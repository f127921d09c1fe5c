#include "Catch.h"
#include "ReadDicom.h"

#include "vtkNew.h"

#include <chrono>
#include <cstdlib>
#include <iterator>
#include <random>

namespace
{

using Syntax = gdcm::TransferSyntax;
using Random = std::mt19937;

// The parser program, and whatever it leaves, are to find this folder for temporary files.
class TemporaryFilesFolder
{
public:
  TemporaryFilesFolder()
  {
    const char* const former = std::getenv("TMPDIR");
    this->Former = former ? former : "";
    setenv("TMPDIR", this->Folder.PathOf("").c_str(), 1);
  }
  ~TemporaryFilesFolder()
  {
    this->Former.empty() ? unsetenv("TMPDIR") : setenv("TMPDIR", this->Former.c_str(), 1);
  }

  TemporaryFolder Folder;

private:
  std::string Former;
};

std::vector<std::string> SoundFiles()
{
  std::vector<std::string> files;
  for (const auto syntax :
    { Syntax::ImplicitVRLittleEndian, Syntax::ExplicitVRLittleEndian, Syntax::ExplicitVRBigEndian,
      Syntax::DeflatedExplicitVRLittleEndian, Syntax::JPEGLosslessProcess14_1,
      Syntax::JPEGLSLossless, Syntax::JPEG2000Lossless, Syntax::RLELossless })
  {
    auto image = Slice(1);
    image.columns = image.rows = 16;
    image.transferSyntax = syntax;
    image.elements["RescaleSlope"] = "2";
    files.push_back(image.File());
    image.frames = 3;
    image.frameGroups.assign(
      3, { { "PlanePositionSequence", { { "ImagePositionPatient", "1\\2\\3" } } } });
    files.push_back(image.File());
  }
  return files;
}

std::size_t Below(Random& random, std::size_t limit)
{
  return static_cast<std::size_t>(random() % limit);
}

std::string CutShort(const std::string& file, Random& random)
{
  return file.substr(0, Below(random, file.size()));
}

std::string WithFlippedBits(std::string file, Random& random)
{
  const std::size_t count = 1 + Below(random, 8);
  for (std::size_t flip = 0; flip < count; ++flip)
  {
    file[132 + Below(random, file.size() - 132)] ^= static_cast<char>(1 << Below(random, 8));
  }
  return file;
}

// An element begins with its group, which is a small even number here, and its length is 4 to 8
// bytes further.
std::string WithOtherLength(std::string file, Random& random)
{
  const std::string values[] = { "\xff\xff", std::string("\0\0", 2), "\xfe\xff", "\x01\x80",
    std::string("\x03\0", 2) };
  const std::string groups[] = { "\x08", "\x10", "\x18", "\x20", "\x28", "\xe0\x7f", "\xfe\xff" };
  const auto& group = groups[Below(random, std::size(groups))];
  const auto place = file.find(group, 132 + Below(random, file.size() - 132));
  if (place != std::string::npos && place + 10 < file.size())
  {
    file.replace(place + 4 + 2 * Below(random, 3), 2, values[Below(random, std::size(values))]);
  }
  return file;
}

std::string WithOtherLayout(Random& random)
{
  const char* const keywords[] = { "Rows", "Columns", "NumberOfFrames", "BitsAllocated",
    "BitsStored", "HighBit", "SamplesPerPixel", "PixelRepresentation" };
  const char* const values[] = { "0", "1", "2", "7", "12", "33", "64", "255", "40000", "65535" };
  auto image = Slice(1);
  for (int change = 0; change < 2; ++change)
  {
    image.elements[keywords[Below(random, std::size(keywords))]] =
      values[Below(random, std::size(values))];
  }
  return image.File();
}

std::string Damaged(const std::vector<std::string>& files, Random& random)
{
  const auto& file = files[Below(random, files.size())];
  switch (Below(random, 4))
  {
    case 0:
      return CutShort(file, random);
    case 1:
      return WithFlippedBits(file, random);
    case 2:
      return WithOtherLength(file, random);
    default:
      return WithOtherLayout(random);
  }
}

}

TEST_CASE("Whatever bytes of a DICOM file change, it is read or refused in one line")
{
  using Clock = std::chrono::steady_clock;
  const TemporaryFolder folder;
  const TemporaryFilesFolder temporary;
  const auto files = SoundFiles();
  for (const auto& file : files)
  {
    REQUIRE(ReadDicom(folder.Write("a.dcm", file), PENUMBRA_DICOM_PARSER).error == "");
  }
  Random random(20);
  const auto start = Clock::now();
  int rounds = 0;
  for (; rounds < 400 && Clock::now() - start < std::chrono::seconds(15); ++rounds)
  {
    const auto path = folder.Write("a.dcm", Damaged(files, random));
    vtkNew<vtkDICOMVolumeReader> reader;
    reader->SetFileName(path.c_str());
    reader->SetParserProgram(PENUMBRA_DICOM_PARSER);
    reader->SetTimeLimit(2.0);
    INFO("round " << rounds);
    const auto before = Clock::now();
    const auto reading = Update(reader);
    CHECK(Clock::now() - before < std::chrono::seconds(8));
    CHECK((reading.volume->GetNumberOfPoints() > 0 || Mentions(reading.error, "a\\.dcm")));
  }
  CHECK(rounds > 50);
  CHECK(temporary.Folder.Names().empty());
}
