#include "Catch.h"
#include "SampleVolume.h"

#include <fstream>

using Catch::Matchers::ContainsSubstring;

TEST_CASE("Files named after another format are refused with both names")
{
  const TemporaryFolder folder;
  const std::pair<std::string, std::string> contents[] = { { "MetaImage", "ObjectType = Image\n" },
    { "NRRD", "NRRD0004\n" }, { "XML", "<?xml version=\"1.0\"?>\n" },
    { "gzip-compressed", Compressed("voxels", true) },
    { "NIfTI", std::string(344, '\0') + std::string("n+1\0", 4) },
    { "unknown", "one text or another" } };
  const std::pair<std::string, std::string> names[] = { { "a.mha", "MetaImage" },
    { "a.mhd", "MetaImage" }, { "a.nrrd", "NRRD" }, { "a.nhdr", "NRRD" }, { "a.vti", "XML" },
    { "a.nii.gz", "gzip-compressed" }, { "a.nii", "NIfTI" } };
  for (const auto& [content, bytes] : contents)
  {
    for (const auto& [name, expected] : names)
    {
      INFO(content << " as " << name);
      const auto failure = FailureOf(folder.Write(name, bytes));
      if (content == expected)
      {
        CHECK_THAT(failure, !ContainsSubstring("its name says"));
      }
      else
      {
        CHECK_THAT(failure,
          ContainsSubstring("content is " + content) && ContainsSubstring("says " + expected));
      }
    }
  }
}

TEST_CASE("What is no volume file is refused in one line")
{
  const TemporaryFolder folder;
  CHECK_THAT(FailureOf(folder.PathOf("gone.nrrd")), ContainsSubstring("no such file"));
  CHECK_THAT(FailureOf(folder.PathOf("")), ContainsSubstring("folder holds no DICOM"));
  CHECK_THAT(FailureOf(folder.Write("a.png", "x")), ContainsSubstring(".nii.gz"));
  CHECK_THAT(FailureOf(folder.Write("noextension", "x")), ContainsSubstring("extension"));
  for (const char* name : { "a.mhd", "a.mha", "a.nrrd", "a.nhdr", "a.nii", "a.nii.gz", "a.vti" })
  {
    INFO(name);
    CHECK_THAT(FailureOf(folder.Write(name, "")), ContainsSubstring("empty"));
  }
}

TEST_CASE("What is named or starts as DICOM but is none is refused")
{
  const TemporaryFolder folder;
  CHECK_THAT(FailureOf(folder.Write("a.dcm", "x")), ContainsSubstring("does not start"));
  CHECK_THAT(FailureOf(folder.Write("IM0001", std::string(128, '\0') + "DICM")),
    ContainsSubstring("extension"));
}

TEST_CASE("A file that may not be read is refused")
{
  const TemporaryFolder folder;
  const auto path = folder.Write("a.mhd", "NDims = 3\n");
  std::filesystem::permissions(path, std::filesystem::perms::none);
  if (std::ifstream(path))
  {
    SKIP("this user may read every file");
  }
  CHECK_THAT(FailureOf(path), ContainsSubstring("cannot be opened"));
}

TEST_CASE("Texts from a file with line ends in them do not break the message")
{
  const TemporaryFolder folder;
  const auto failure = FailureOf(folder.Write("a.vti",
    "<VTKFile type=\"ImageData\"><ImageData WholeExtent=\"a\nb\"><Piece/></ImageData></VTKFile>"));
  CHECK_THAT(failure, ContainsSubstring("a b"));
}
