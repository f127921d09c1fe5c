#include "Catch.h"
#include "SampleVolume.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkOutputWindow.h"

using Catch::Matchers::ContainsSubstring;

namespace
{

// A VTI file of the sample as blocks compressed by zlib, with a header of these numbers.
std::string WithBlocks(const std::vector<unsigned int>& header, const std::string& blocks)
{
  std::string file = "<VTKFile type=\"ImageData\" byte_order=\"LittleEndian\" "
                     "compressor=\"vtkZLibDataCompressor\"><ImageData WholeExtent=\"0 2 0 3 0 4\">"
                     "<Piece Extent=\"0 2 0 3 0 4\"><PointData Scalars=\"a\"><DataArray Name=\"a\" "
                     "type=\"Int16\" format=\"appended\" offset=\"0\"/></PointData></Piece>"
                     "</ImageData><AppendedData encoding=\"raw\">_";
  for (const unsigned int number : header)
  {
    file += Bytes(number);
  }
  return file + blocks + "</AppendedData></VTKFile>";
}

struct Sample
{
  std::string first = Compressed(SampleBytes<short>().substr(0, 80), false);
  std::string second = Compressed(SampleBytes<short>().substr(80), false);
  unsigned int firstSize = static_cast<unsigned int>(first.size());
  unsigned int secondSize = static_cast<unsigned int>(second.size());
};

}

TEST_CASE("VTI blocks that do not add up to the volume are refused before they are read")
{
  const TemporaryFolder folder;
  const Sample s;
  const std::string blocks = s.first + s.second;
  CHECK(IsSample(
    Read(folder.Write("a.vti", WithBlocks({ 2, 80, 40, s.firstSize, s.secondSize }, blocks)))));
  // Number of blocks, size of a full one, size of a partial last one or 0, compressed sizes.
  const std::vector<unsigned int> impossible[] = { { 2, 120, 120, s.firstSize, s.secondSize },
    { 2, 80, 0, s.firstSize, s.secondSize }, { 2, 80, 41, s.firstSize, s.secondSize },
    { 1, 80, 0, s.firstSize }, { 0, 80, 40 }, { 4000000000u, 80, 40 },
    { 3, 0xffffffffu, 122, s.firstSize, s.secondSize, 0 } };
  for (const auto& header : impossible)
  {
    INFO(header[0] << " blocks of " << header[1] << ", partial " << header[2]);
    CHECK_THAT(FailureOf(folder.Write("b.vti", WithBlocks(header, blocks))),
      ContainsSubstring("do not add up to 120 bytes"));
  }
  CHECK_THAT(
    FailureOf(folder.Write("c.vti", WithBlocks({ 2, 80, 40, s.firstSize, 4000000000u }, blocks))),
    ContainsSubstring("exceeds the file"));
}

TEST_CASE("Damaged VTI blocks are refused without a word from VTK")
{
  const TemporaryFolder folder;
  Sample s;
  s.second[4] ^= 0x55;
  int words = 0;
  vtkNew<vtkCallbackCommand> counter;
  counter->SetClientData(&words);
  counter->SetCallback(
    [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
  const auto tag = vtkOutputWindow::GetInstance()->AddObserver(vtkCommand::AnyEvent, counter);
  CHECK_THAT(FailureOf(folder.Write(
               "a.vti", WithBlocks({ 2, 80, 40, s.firstSize, s.secondSize }, s.first + s.second))),
    ContainsSubstring("damaged"));
  vtkOutputWindow::GetInstance()->RemoveObserver(tag);
  CHECK(words == 0);
}
