#include "FormatReaders.h"
#include "HeaderText.h"
#include "ReaderErrors.h"
#include "VolumeGeometry.h"
#include "VoxelData.h"
#include "XmlHeader.h"
#include "XmlVoxelChecks.h"
#include "vtkDataArray.h"
#include "vtkDataCompressor.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLDataParser.h"
#include "vtkXMLImageDataReader.h"

#include <algorithm>
#include <exception>

namespace penumbra
{

namespace
{

void RemoveAllBut(vtkXMLDataElement* child)
{
  const vtkSmartPointer<vtkXMLDataElement> kept = child;
  vtkXMLDataElement* const parent = child->GetParent();
  parent->RemoveAllNestedElements();
  parent->AddNestedElement(kept);
}

void CheckEnd(const std::filesystem::path& path)
{
  constexpr std::uint64_t length = 64;
  const std::uint64_t size = SizeOfFile(path);
  const std::string end = Trimmed(ReadBytes(path, size - std::min(size, length), length));
  const std::string closingTag = "</VTKFile>";
  if (end.size() < closingTag.size() ||
    end.compare(end.size() - closingTag.size(), closingTag.size(), closingTag) != 0)
  {
    throw VolumeReadingError("it does not end with </VTKFile>; the file is cut short");
  }
}

/**
 * Checks what the file says of the voxels before they are read, and takes everything else from what
 * vtkXMLImageDataReader gets to see: it would read field data of any size unasked.
 */
class XmlVoxelReader : public vtkXMLImageDataReader
{
public:
  static XmlVoxelReader* New();
  vtkTypeMacro(XmlVoxelReader, vtkXMLImageDataReader);

  std::filesystem::path Path;
  ReaderErrors* Errors = nullptr;
  VolumeGeometry Geometry;
  int ScalarType = VTK_VOID;
  std::string Name;
  Warnings Notes;
  /// What the check threw; VTK has to get to the end of its own functions.
  std::exception_ptr Failure;

protected:
  void CreateXMLParser() override
  {
    this->Superclass::CreateXMLParser();
    this->Errors->Observe(this->XMLParser);
  }

  int ReadPrimaryElement(vtkXMLDataElement* image) override
  {
    try
    {
      this->Check(image);
    }
    catch (...)
    {
      this->Failure = std::current_exception();
      return 0;
    }
    if (this->XMLParser->GetCompressor() != nullptr)
    {
      this->Errors->Observe(this->XMLParser->GetCompressor());
    }
    return this->Superclass::ReadPrimaryElement(image);
  }

private:
  void Check(vtkXMLDataElement* image)
  {
    this->Geometry = XmlGeometry(image);
    vtkXMLDataElement* const array = XmlScalars(image, this->Notes);
    this->ScalarType = XmlScalarType(array);
    const std::uint64_t scalarSize = vtkDataArray::GetDataTypeSize(this->ScalarType);
    const std::uint64_t count = NumberOfVoxels(this->Geometry, scalarSize);
    CheckXmlVoxels(WhereVoxelsAre(this->Path, array, this->XMLParser), this->ScalarType, count);
    CheckMemory(count * scalarSize);

    vtkXMLDataElement* const pointData = array->GetParent();
    const char* const name = array->GetAttribute("Name");
    this->Name = name == nullptr ? "scalars" : name;
    array->SetAttribute("Name", this->Name.c_str());
    pointData->SetAttribute("Scalars", this->Name.c_str());
    array->RemoveAllNestedElements();
    RemoveAllBut(array);
    RemoveAllBut(pointData);
    RemoveAllBut(pointData->GetParent());
  }
};

vtkStandardNewMacro(XmlVoxelReader);

}

Volume ReadXmlImageVolume(const std::filesystem::path& path, Warnings& warnings)
{
  CheckEnd(path);
  ReaderErrors errors;
  vtkNew<XmlVoxelReader> reader;
  reader->Path = path;
  reader->Errors = &errors;
  reader->SetFileName(path.u8string().c_str());
  errors.Observe(reader);
  errors.Observe(reader->GetExecutive());
  reader->UpdateInformation();
  if (reader->Failure)
  {
    std::rethrow_exception(reader->Failure);
  }
  errors.ThrowIfAny();
  warnings.insert(warnings.end(), reader->Notes.begin(), reader->Notes.end());
  auto voxels = RunReader(reader, errors, reader->Geometry, reader->ScalarType);
  return FinishedVolume(reader->Geometry, voxels, warnings, reader->Name);
}

}
