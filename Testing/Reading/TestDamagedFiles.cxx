#include "Catch.h"
#include "NiftiSample.h"
#include "vtkNew.h"
#include "vtkXMLImageDataWriter.h"

#include <fstream>
#include <iterator>
#include <random>

using Catch::Matchers::ContainsSubstring;

namespace
{

struct File
{
  std::string name;
  std::string bytes;
};

const std::string MetaImage = "ObjectType = Image\nNDims = 3\nDimSize = 3 4 5\n";
const std::string Nrrd = "NRRD0004\ntype: short\ndimension: 3\nsizes: 3 4 5\nendian: little\n";
const std::string MetaImageEnd = "ElementType = MET_SHORT\nElementDataFile = LOCAL\n";

std::string XmlImage(const TemporaryFolder& folder, const std::string& sample, int compressor)
{
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(Read(sample));
  writer->SetFileName(folder.PathOf("written.vti").c_str());
  writer->SetCompressorType(compressor);
  writer->EncodeAppendedDataOff();
  writer->SetBlockSize(40);
  writer->Write();
  std::ifstream file(folder.PathOf("written.vti"), std::ios::binary);
  std::string bytes{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  // A text file may end with its last line's end or without.
  bytes.resize(bytes.find_last_of('>') + 1);
  return bytes;
}

// One sound file of each format and encoding whose every byte is needed.
std::vector<File> SoundFiles(const TemporaryFolder& folder)
{
  const auto voxels = SampleBytes<short>();
  const auto zlib = Compressed(voxels, false);
  std::vector<File> files{ { "a.mha", MetaImage + MetaImageEnd + voxels },
    { "b.mha",
      MetaImage + "CompressedData = True\nCompressedDataSize = " + std::to_string(zlib.size()) +
        "\n" + MetaImageEnd + zlib },
    { "a.nrrd", Nrrd + "encoding: raw\n\n" + voxels },
    { "b.nrrd", Nrrd + "encoding: gzip\n\n" + Compressed(voxels, true) },
    { "a.nii", NiftiSample().File(voxels) },
    { "a.nii.gz", Compressed(NiftiSample().File(voxels), true) } };
  const auto sample = folder.Write("sample.mha", files[0].bytes);
  for (const int compressor :
    { vtkXMLWriter::NONE, vtkXMLWriter::ZLIB, vtkXMLWriter::LZ4, vtkXMLWriter::LZMA })
  {
    files.push_back(
      { "c" + std::to_string(compressor) + ".vti", XmlImage(folder, sample, compressor) });
  }
  return files;
}

}

TEST_CASE("Files cut short at any byte are refused")
{
  const TemporaryFolder folder;
  for (const File& file : SoundFiles(folder))
  {
    REQUIRE(IsSample(Read(folder.Write(file.name, file.bytes))));
    for (std::size_t size = 0; size < file.bytes.size(); ++size)
    {
      INFO(file.name << " cut after " << size << " of " << file.bytes.size() << " bytes");
      REQUIRE(FailureOf(folder.Write(file.name, file.bytes.substr(0, size))) != "was read");
    }
  }
}

TEST_CASE("Files that are longer than they say are refused")
{
  const TemporaryFolder folder;
  for (const File& file : SoundFiles(folder))
  {
    INFO(file.name);
    CHECK(FailureOf(folder.Write(file.name, file.bytes + "x")) != "was read");
  }
}

TEST_CASE("Damaged gzip data is noticed by its checksum")
{
  const TemporaryFolder folder;
  // Stored, not compressed, so that a changed voxel breaks nothing but the checksum.
  auto file = Compressed(NiftiSample().File(SampleBytes<short>()), true);
  REQUIRE(IsSample(Read(folder.Write("a.nii.gz", file))));
  file[file.size() - 6] ^= 1;
  CHECK_THAT(FailureOf(folder.Write("a.nii.gz", file)), ContainsSubstring("damaged"));
}

TEST_CASE("Whatever bytes change, a file is read or refused in one line")
{
  const TemporaryFolder folder;
  std::mt19937 random(1);
  const auto below = [&](std::size_t limit) { return static_cast<std::size_t>(random() % limit); };
  for (const File& file : SoundFiles(folder))
  {
    for (int round = 0; round < 200; ++round)
    {
      std::string bytes = file.bytes;
      for (std::size_t change = 0; change <= below(4); ++change)
      {
        bytes[below(bytes.size())] = static_cast<char>(random());
      }
      INFO(file.name << ", round " << round);
      FailureOf(folder.Write(file.name, bytes));
    }
  }
}

TEST_CASE("A small file that claims a huge volume is refused by its size")
{
  const TemporaryFolder folder;
  const auto failure = [&](const std::string& name, const std::string& bytes)
  { return FailureOf(folder.Write(name, bytes)); };
  const std::string sizes = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 100000 100000 100000\n";
  const auto data = Compressed(std::string(1000000, '\0'), true);
  CHECK_THAT(failure("a.nrrd", sizes + "encoding: gzip\n\n" + data),
    ContainsSubstring("need more, even compressed"));

  const std::string extent = "Extent=\"0 99999 0 99999 0 99999\"";
  const std::string start = "<VTKFile type=\"ImageData\" compressor=\"vtkZLibDataCompressor\">"
                            "<ImageData Whole" +
    extent + "><Piece " + extent + "><PointData Scalars=\"a\"><DataArray Name=\"a\" type=\"Int8\" ";
  const std::string end = "</DataArray></PointData></Piece></ImageData></VTKFile>";
  for (const char* array : { "format=\"ascii\">1 2 3", "format=\"binary\">AAAA" })
  {
    CHECK_THAT(failure("a.vti", start + array + end), ContainsSubstring("too few"));
  }
}
