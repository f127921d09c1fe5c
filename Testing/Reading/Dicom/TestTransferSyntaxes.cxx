#include "Catch.h"
#include "ReadDicom.h"

namespace
{

using Syntax = gdcm::TransferSyntax;

std::vector<Syntax::TSType> Syntaxes()
{
  return { Syntax::ImplicitVRLittleEndian, Syntax::ExplicitVRLittleEndian,
    Syntax::ExplicitVRBigEndian, Syntax::DeflatedExplicitVRLittleEndian,
    Syntax::JPEGLosslessProcess14, Syntax::JPEGLosslessProcess14_1, Syntax::JPEGLSLossless,
    Syntax::JPEG2000Lossless, Syntax::RLELossless };
}

// Images large enough that a codec has something to do.
DicomSample Encoded(DicomSample image, Syntax::TSType syntax, int bits, bool isSigned)
{
  image.columns = 37;
  image.rows = 24;
  image.transferSyntax = syntax;
  image.bitsAllocated = bits <= 8 ? 8 : 16;
  image.bitsStored = bits;
  image.highBit = bits - 1;
  image.isSigned = isSigned;
  const long long lowest = isSigned ? -(1LL << (bits - 1)) : 0;
  image.stored = [lowest, bits](int i, int j, int k)
  { return lowest + (i * i + 131 * j + 977 * k) % (1LL << bits); };
  return image;
}

}

TEST_CASE("Every lossless transfer syntax gives the same voxels")
{
  const auto parser = GENERATE(from_range(Parsers()));
  const auto syntax = GENERATE(from_range(Syntaxes()));
  for (const int bits : { 8, 12, 16 })
  {
    for (const bool isSigned : { false, true })
    {
      auto slices = Slices(2);
      for (auto& slice : slices)
      {
        slice = Encoded(slice, syntax, bits, isSigned);
      }
      INFO(Syntax::GetTSString(syntax) << ", " << bits << " bits, signed: " << isSigned);
      const auto reading = ReadSlices(slices, parser);
      CHECK(reading.error == "");
      CHECK(reading.Warnings() == "");
      CHECK(Difference(reading.volume, slices) == "");
    }
  }
}

TEST_CASE("Every lossless transfer syntax gives the same frames")
{
  const auto parser = GENERATE(from_range(Parsers()));
  const auto syntax = GENERATE(from_range(Syntaxes()));
  INFO(Syntax::GetTSString(syntax));
  auto image = Slice(0);
  image.frames = 4;
  image.elements["SpacingBetweenSlices"] = "2.5";
  image = Encoded(image, syntax, 12, false);
  const TemporaryFolder folder;
  const auto reading = ReadDicom(folder.Write("frames.dcm", image.File()), parser);
  REQUIRE(reading.error == "");
  REQUIRE(reading.volume->GetDimensions()[2] == 4);
  bool same = true;
  for (int k = 0; k < 4; ++k)
  {
    for (int j = 0; j < image.rows; ++j)
    {
      for (int i = 0; i < image.columns; ++i)
      {
        same =
          same && reading.volume->GetScalarComponentAsDouble(i, j, k, 0) == image.stored(i, j, k);
      }
    }
  }
  CHECK(same);
}

TEST_CASE("A file that is cut short is refused, whatever its transfer syntax")
{
  const auto syntax = GENERATE(from_range(Syntaxes()));
  const std::size_t missing = GENERATE(20, 60, 200);
  INFO(Syntax::GetTSString(syntax) << " without " << missing << " bytes");
  const TemporaryFolder folder;
  const auto file = Encoded(Slice(0), syntax, 12, false).File();
  const auto path = folder.Write("cut.dcm", file.substr(0, file.size() - missing));
  CHECK(Mentions(ReadDicom(path, PENUMBRA_DICOM_PARSER).error, "cut\\.dcm"));
}

TEST_CASE("Slices of several transfer syntaxes are one volume")
{
  DicomSlices slices;
  for (const auto syntax : Syntaxes())
  {
    slices.push_back(Encoded(Slice(static_cast<int>(slices.size())), syntax, 12, false));
  }
  CHECK(Difference(ReadSlices(slices).volume, slices) == "");
}

TEST_CASE("Files without a preamble or a meta header are read")
{
  const auto parser = GENERATE(from_range(Parsers()));
  const TemporaryFolder folder;
  auto slices = Slices(4);
  for (auto& slice : slices)
  {
    slice.transferSyntax = Syntax::ImplicitVRLittleEndian;
  }
  slices[1].transferSyntax = Syntax::ExplicitVRLittleEndian;
  folder.Write("0", slices[0].File());
  folder.Write("1", WithoutPreamble(slices[1].File()));
  folder.Write("2", WithoutPreamble(slices[2].File()));
  folder.Write("3", WithoutMetaHeader(slices[3].File()));
  const auto reading = ReadDicom(folder.PathOf(""), parser);
  CHECK(reading.error == "");
  CHECK(Difference(reading.volume, slices) == "");
}

TEST_CASE("A file of an unknown transfer syntax is refused")
{
  const TemporaryFolder folder;
  auto file = Slice(0).File();
  const std::string explicitSyntax = "1.2.840.10008.1.2.1";
  file.replace(file.find(explicitSyntax), explicitSyntax.size(), "1.2.840.10008.1.2.9");
  const auto path = folder.Write("unknown.dcm", file);
  for (const auto& parser : Parsers())
  {
    CHECK(Mentions(ReadDicom(path, parser).error, "unknown\\.dcm"));
  }
}

TEST_CASE("GE's private transfer syntax has the bytes of its pixels the other way round")
{
  const auto slices = Slices(2);
  auto turned = slices;
  for (auto& slice : turned)
  {
    slice.transferSyntax = Syntax::ImplicitVRLittleEndian;
    const auto stored = slice.stored;
    slice.stored = [stored](int i, int j, int k)
    {
      const long long value = stored(i, j, k);
      return (value & 255) << 8 | value >> 8;
    };
  }
  const TemporaryFolder folder;
  for (const auto& slice : turned)
  {
    auto file = slice.File();
    const std::string implicit = std::string("1.2.840.10008.1.2") + '\0';
    const auto at = file.find(implicit);
    REQUIRE(at != std::string::npos);
    file.replace(at, implicit.size(), "1.2.840.113619.5.2");
    folder.Write(slice.elements.at("InstanceNumber"), file);
  }
  CHECK(Difference(ReadDicom(folder.PathOf("")).volume, slices) == "");
}
