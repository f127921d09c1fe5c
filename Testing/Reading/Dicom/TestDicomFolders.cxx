#include "Catch.h"
#include "ReadDicom.h"
#include "VolumeFile.h"

#include <cstdlib>
#include <filesystem>

namespace fs = std::filesystem;

namespace
{

fs::path PathIn(const TemporaryFolder& folder, const std::string& name)
{
  return fs::u8path(folder.PathOf(name));
}

void CheckSlices(const std::string& path, const DicomSlices& slices)
{
  for (const auto& parser : Parsers())
  {
    INFO(path << (parser.empty() ? "" : ", by the parser program"));
    const auto reading = ReadDicom(path, parser);
    CHECK(reading.error == "");
    CHECK((reading.Warnings() == "" || slices.size() == 1));
    CHECK(Difference(reading.volume, slices) == "");
  }
}

}

TEST_CASE("Names of files and folders do not matter")
{
  const TemporaryFolder folder;
  const auto slices = Slices(4);
  const std::string part = "a b/\u00fcn\u00ef c\u00f6d\u00e9 \u65e5\u672c/";
  folder.Write(part + "no extension", slices[0].File());
  folder.Write(part + "\u5199\u771f.txt", slices[1].File());
  folder.Write(part + "'quoted\" $name;.dcm", slices[2].File());
  folder.Write(part + "-option", slices[3].File());
  CheckSlices(folder.PathOf(""), slices);
  CheckSlices(folder.PathOf(part + "\u5199\u771f.txt"), { slices[1] });
  CheckSlices(folder.PathOf(part + "-option"), { slices[3] });
}

TEST_CASE("Other files in the folder do not matter")
{
  const TemporaryFolder folder;
  const auto slices = Slices(4);
  WriteSlices(folder, slices);
  folder.Write("notes.txt", "The patient was asked to hold his breath.\n");
  folder.Write("picture.png", "\x89PNG\r\n\x1a\n and no more");
  folder.Write("empty.dcm", "");
  folder.Write("zeros.dcm", std::string(5000, '\0'));
  CheckSlices(folder.PathOf(""), slices);
  folder.Write("short.dcm", std::string(128, '\0') + "DICM");
  const auto reading = ReadDicom(folder.PathOf(""), PENUMBRA_DICOM_PARSER);
  CHECK(Difference(reading.volume, slices) == "");
}

TEST_CASE("A file that is cut short is left out, interpolated and named in the warnings")
{
  const TemporaryFolder folder;
  auto slices = Slices(5);
  const auto file = slices[2].File();
  const std::size_t missing = GENERATE(2, 20, 40, 300);
  INFO(missing << " of " << file.size() << " bytes");
  WriteSlices(folder, slices);
  folder.Write("2.dcm", file.substr(0, file.size() - missing));
  const auto reading = ReadDicom(folder.PathOf(""), PENUMBRA_DICOM_PARSER);
  // Of 100 and 900.
  slices[2].stored = [](int i, int j, int) { return i + 10 * j + 500; };
  CHECK(Difference(reading.volume, slices) == "");
  CHECK(Mentions(reading.Warnings(), "2\\.dcm"));
}

TEST_CASE("Symbolic links are followed once")
{
  const TemporaryFolder folder;
  const TemporaryFolder other;
  const auto slices = Slices(4);
  WriteSlices(other, { slices[0], slices[1] }, "there/");
  folder.Write("2.dcm", slices[2].File());
  other.Write("3.dcm", slices[3].File());
  fs::create_directory_symlink(PathIn(other, "there"), PathIn(folder, "link to a folder"));
  fs::create_symlink(PathIn(other, "3.dcm"), PathIn(folder, "link to a file"));
  fs::create_symlink(PathIn(folder, "2.dcm"), PathIn(folder, "link to a file beside it"));
  fs::create_symlink(PathIn(other, "missing"), PathIn(folder, "link to nothing"));
  fs::create_directory_symlink(PathIn(folder, ""), PathIn(folder, "link to itself"));
  fs::create_directory_symlink(PathIn(folder, ""), PathIn(other, "there/link back"));
  CheckSlices(folder.PathOf(""), slices);
  CheckSlices(folder.PathOf("link to a file"), { slices[3] });
  CheckSlices(folder.PathOf("link to a folder"), slices);
}

TEST_CASE("A folder that cannot be written is read")
{
  const TemporaryFolder folder;
  const auto slices = Slices(3);
  WriteSlices(folder, slices, "discs/");
  const auto readable = fs::perms::owner_read | fs::perms::owner_exec;
  fs::permissions(PathIn(folder, "discs"), readable);
  CheckSlices(folder.PathOf("discs"), slices);
  fs::permissions(PathIn(folder, "discs"), fs::perms::owner_all);
  CHECK(folder.Names() == std::vector<std::string>{ "discs" });
}

TEST_CASE("What is no file does not hang the reader")
{
  const TemporaryFolder folder;
  const auto slices = Slices(3);
  WriteSlices(folder, slices);
  fs::create_symlink("/dev/zero", PathIn(folder, "device"));
  const auto command = "mkfifo '" + folder.PathOf("pipe") + "'";
  REQUIRE(std::system(command.c_str()) == 0);
  CheckSlices(folder.PathOf(""), slices);
}

TEST_CASE("A pipe is refused, not waited for")
{
  const auto parser = GENERATE(from_range(Parsers()));
  const std::string name = GENERATE("pipe", "pipe.dcm", "DICOMDIR");
  const TemporaryFolder folder;
  const auto pipe = folder.PathOf(name);
  REQUIRE(std::system(("mkfifo '" + pipe + "'").c_str()) == 0);
  CHECK(Mentions(ReadDicom(pipe, parser).error, "cannot be opened"));
  std::vector<std::string> warnings;
  CHECK_THROWS_AS(penumbra::ReadVolumeFile(pipe, {}, warnings), penumbra::VolumeReadingError);
}
