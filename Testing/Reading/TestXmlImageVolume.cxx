#include "Catch.h"
#include "SampleVolume.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkXMLImageDataWriter.h"

using Catch::Matchers::ContainsSubstring;

namespace
{

std::string Document(const std::string& image, const std::string& array,
  const std::string& pointData = "<PointData Scalars=\"density\">")
{
  return "<?xml version=\"1.0\"?>\n<!-- <DataArray> > -->\n<VTKFile type=\"ImageData\" "
         "version=\"0.1\" byte_order=\"LittleEndian\">\n<ImageData " +
    image + "><Piece Extent=\"0 2 0 3 0 4\">" + pointData + "<DataArray Name=\"density\" " + array +
    "</DataArray></PointData><CellData/></Piece></ImageData></VTKFile>\n";
}

const std::string Extent = "WholeExtent=\"0 2 0 3 0 4\"";
const std::string Image = Extent + " Origin=\"0 0 0\" Spacing=\"1 1 1\"";
const std::string Text = "type=\"Int16\" format=\"ascii\">" + SampleText();

}

TEST_CASE("What VTK writes as VTI is read in every mode and with every compressor")
{
  const TemporaryFolder folder;
  const auto sample = Read(folder.Write("a.vti", Document(Image, Text)));
  REQUIRE(IsSample(sample));
  sample->SetOrigin(1, 2, 3);
  sample->SetSpacing(2, 3, 4);
  const double direction[9] = { 0, -1, 0, 1, 0, 0, 0, 0, -1 };
  sample->SetDirectionMatrix(direction);
  for (const int mode : { vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended })
  {
    for (const int compressor :
      { vtkXMLWriter::NONE, vtkXMLWriter::ZLIB, vtkXMLWriter::LZ4, vtkXMLWriter::LZMA })
    {
      for (const bool variant : { false, true })
      {
        INFO("mode " << mode << ", compressor " << compressor << ", variant " << variant);
        vtkNew<vtkXMLImageDataWriter> writer;
        writer->SetInputData(sample);
        writer->SetFileName(folder.PathOf("b.vti").c_str());
        writer->SetDataMode(mode);
        writer->SetCompressorType(compressor);
        writer->SetBlockSize(40);
        writer->SetEncodeAppendedData(variant);
        writer->SetHeaderType(variant ? vtkXMLWriter::UInt64 : vtkXMLWriter::UInt32);
        writer->SetByteOrder(variant ? vtkXMLWriter::BigEndian : vtkXMLWriter::LittleEndian);
        writer->Write();
        const auto image = Read(folder.PathOf("b.vti"));
        CHECK(IsSample(image));
        CHECK(image->GetScalarType() == VTK_SHORT);
        CHECK(image->GetPointData()->GetScalars()->GetName() == std::string("density"));
        CHECK(IsPlaced(image, { 1, 2, 3 }, { { { 0, 2, 0 }, { -3, 0, 0 }, { 0, 0, -4 } } }));
      }
    }
  }
}

TEST_CASE("A VTI extent that does not begin at 0 leaves the voxels where they are")
{
  const TemporaryFolder folder;
  vtkNew<vtkImageData> shifted;
  shifted->DeepCopy(Read(folder.Write("a.vti", Document(Image, Text))));
  shifted->SetExtent(10, 12, -5, -2, 1, 5);
  shifted->SetSpacing(2, 3, 4);
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(shifted);
  writer->SetFileName(folder.PathOf("b.vti").c_str());
  writer->Write();
  const auto image = Read(folder.PathOf("b.vti"));
  CHECK(IsSample(image));
  CHECK(IsPlaced(image, { 20, -15, 4 }, { { { 2, 0, 0 }, { 0, 3, 0 }, { 0, 0, 4 } } }));
}

TEST_CASE("Without named scalars a VTI file's first array is read, with a warning")
{
  const TemporaryFolder folder;
  std::vector<std::string> warnings;
  const auto path = folder.Write("a.vti", Document(Image, Text, "<PointData>"));
  CHECK(IsSample(penumbra::ReadVolumeFile(path, {}, warnings)));
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0], ContainsSubstring("density"));
}

TEST_CASE("VTI files that hold no scalar volume are refused by name")
{
  const TemporaryFolder folder;
  const auto failure = [&](const std::string& image, const std::string& array,
                         const std::string& pointData = "<PointData Scalars=\"density\">")
  { return FailureOf(folder.Write("a.vti", Document(image, array, pointData))); };
  CHECK_THAT(failure(Image, Text, "<PointData Scalars=\"gone\">"), ContainsSubstring("\"gone\""));
  CHECK_THAT(failure(Image, "NumberOfComponents=\"3\" " + Text), ContainsSubstring("per voxel"));
  CHECK_THAT(failure(Image, "type=\"String\" format=\"ascii\">"), ContainsSubstring("String"));
  CHECK_THAT(failure(Image, Text + " 7"), ContainsSubstring("more than the 60"));
  CHECK_THAT(failure(Extent + " Spacing=\"1 0 1\"", Text), ContainsSubstring("spacing"));
  CHECK_THAT(
    failure(Image + " Direction=\"1 0 0 0 0 0 0 0 1\"", Text), ContainsSubstring("direction"));
  CHECK_THAT(failure("WholeExtent=\"0 99999 0 99999 0 99999\"", Text), ContainsSubstring("extent"));
  CHECK_THAT(failure("WholeExtent=\"0 -1 0 3 0 4\"", Text), ContainsSubstring("dimensions"));
  CHECK_THAT(failure("", Text), ContainsSubstring("lacks the attribute WholeExtent"));
  const std::string polygons = "<VTKFile type=\"PolyData\"><PolyData></PolyData></VTKFile>";
  CHECK_THAT(FailureOf(folder.Write("b.vti", polygons)), ContainsSubstring("ImageData"));
}
