#include "Catch.h"
#include "ReadDicom.h"

#include "vtkNew.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include <fcntl.h>
#include <unistd.h>

namespace
{

// While it lasts, the first files that are opened become standard input and output.
class WithoutStandardFiles
{
public:
  WithoutStandardFiles()
  {
    for (int file = 0; file < 2; ++file)
    {
      this->Kept[file] = fcntl(file, F_DUPFD_CLOEXEC, 3); // not in place of one closed before
      close(file);
    }
  }

  ~WithoutStandardFiles()
  {
    for (int file = 0; file < 2; ++file)
    {
      dup2(this->Kept[file], file);
      close(this->Kept[file]);
    }
  }
  WithoutStandardFiles(const WithoutStandardFiles&) = delete;
  WithoutStandardFiles& operator=(const WithoutStandardFiles&) = delete;

private:
  int Kept[2];
};

// A program in place of the parser, as a shell script.
std::string Script(const TemporaryFolder& folder, const std::string& commands)
{
  const auto path = folder.Write("scripts/parser", "#!/bin/sh\n" + commands + "\n");
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  return path;
}

// The numbers after each "progress" in messages of CBOR (RFC 8949), whatever else these hold.
std::vector<double> ProgressIn(const std::string& messages)
{
  const std::string key = "progress";
  std::vector<double> values;
  for (auto at = messages.find(key); at != std::string::npos; at = messages.find(key, at + 1))
  {
    const auto number = messages.begin() + static_cast<std::ptrdiff_t>(at + key.size());
    const int size = *number == '\xfb' ? 8 : 4;
    REQUIRE((size == 8 || *number == '\xfa'));
    std::string bytes(number + 1, number + 1 + size);
    std::reverse(bytes.begin(), bytes.end());
    float shortValue = 0.0F;
    double value = 0.0;
    std::memcpy(size == 8 ? static_cast<void*>(&value) : &shortValue, bytes.data(), bytes.size());
    values.push_back(size == 8 ? value : shortValue);
  }
  return values;
}

std::string ErrorOf(const std::string& path, const std::string& program)
{
  vtkNew<vtkDICOMVolumeReader> reader;
  reader->SetFileName(path.c_str());
  reader->SetParserProgram(program.c_str());
  reader->SetTimeLimit(0.5);
  const auto start = std::chrono::steady_clock::now();
  const auto error = Update(reader).error;
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(20));
  return error;
}

}

TEST_CASE("Whatever becomes of the parser program, the file is refused")
{
  const std::string commands = GENERATE("kill -ABRT $$", "kill -SEGV $$", "exec sleep 60", "exit 3",
    "exit 0", "echo nonsense", "exec yes", "cat >/dev/null; exit 0", "head -c 1000000 /dev/urandom",
    "head -c 100000 /dev/zero; exec sleep 60");
  INFO(commands);
  const TemporaryFolder folder;
  const auto file = folder.Write("slice.dcm", Slice(0).File());
  CHECK(Mentions(ErrorOf(file, Script(folder, commands)), "slice\\.dcm"));
}

TEST_CASE("A parser program that is missing or cannot be run is named")
{
  const TemporaryFolder folder;
  const auto file = folder.Write("slice.dcm", Slice(0).File());
  CHECK(Mentions(ErrorOf(file, folder.PathOf("no parser")), "no parser"));
  CHECK(Mentions(ErrorOf(file, folder.Write("no program", "x")), "no program"));
}

TEST_CASE("A file whose compressed pixels are damaged is left out, interpolated and told")
{
  auto slices = Slices(5);
  for (auto& slice : slices)
  {
    slice.columns = slice.rows = 16;
  }
  slices[2].transferSyntax = GENERATE(gdcm::TransferSyntax::JPEG2000Lossless,
    gdcm::TransferSyntax::JPEGLSLossless, gdcm::TransferSyntax::JPEGLosslessProcess14_1);
  const TemporaryFolder folder;
  WriteSlices(folder, slices, "slices/");
  auto file = slices[2].File();
  // The stream begins with a marker, after the empty offset table and its own item's header.
  const std::string emptyTable("\xfe\xff\x00\xe0\0\0\0\0", 8);
  const auto start = file.find('\xff', file.find(emptyTable) + 2 * emptyTable.size());
  file.replace(start, 30, std::string(30, '\x5a'));
  folder.Write("slices/2.dcm", file);
  const auto reading = ReadDicom(folder.PathOf("slices"), PENUMBRA_DICOM_PARSER);
  CHECK(reading.error == "");
  // Of 100 and 900.
  slices[2].stored = [](int i, int j, int) { return i + 10 * j + 500; };
  CHECK(Difference(reading.volume, slices) == "");
  CHECK(Mentions(reading.Warnings(), "2\\.dcm"));
}

TEST_CASE("A file that ends the parser program is left out and told")
{
  const TemporaryFolder folder;
  const auto slices = Slices(3);
  WriteSlices(folder, slices, "slices/");
  auto broken = Slice(7).File();
  const std::string uid = "1.2.3.4.99";
  // A length far beyond the file's end.
  broken.replace(broken.find(uid) - 2, 2, "\xfe\xff");
  folder.Write("slices/broken.dcm", broken);
  const auto reading = ReadDicom(folder.PathOf("slices"), PENUMBRA_DICOM_PARSER);
  CHECK(reading.error == "");
  CHECK(Difference(reading.volume, slices) == "");
  CHECK(Mentions(reading.Warnings(), "broken\\.dcm"));
}

TEST_CASE("The parser program works for a process without standard input and output")
{
  const TemporaryFolder folder;
  WriteSlices(folder, Slices(3));
  vtkNew<vtkDICOMVolumeReader> reader;
  reader->SetFileName(folder.PathOf("").c_str());
  reader->SetParserProgram(PENUMBRA_DICOM_PARSER);
  {
    const WithoutStandardFiles without;
    reader->Update();
  }
  CHECK(Difference(Update(reader).volume, Slices(3)) == "");
}

TEST_CASE("The parser program tells how many slices it has started, whichever they are")
{
  constexpr int count = 24;
  const TemporaryFolder folder;
  auto slices = Slices(count);
  for (auto& slice : slices)
  {
    slice.columns = slice.rows = 256;
  }
  WriteSlices(folder, slices, "slices/");
  const auto log = folder.PathOf("log");
  const auto script = Script(folder, "\"" PENUMBRA_DICOM_PARSER "\" | tee '" + log + "'");
  REQUIRE(ReadDicom(folder.PathOf("slices"), script).error == "");
  std::ifstream file(log, std::ios::binary);
  const auto told = ProgressIn({ std::istreambuf_iterator<char>(file), {} });
  REQUIRE(told.size() == 2 * count); // headers, then voxels
  const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  for (int index = 0; index < count; ++index)
  {
    CHECK(told[count + index] <= (index + threads - 1.0) / count + 1e-6);
  }
}
