#include "ByteStream.h"
#include "FormatReaders.h"
#include "HeaderText.h"
#include "VolumeGeometry.h"
#include "VoxelArray.h"
#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkDataCompressor.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkXMLDataParser.h"
#include "vtkXMLImageDataReader.h"

#include <algorithm>

namespace penumbra
{

namespace
{

// The most that one byte of a compressed file can stand for: LZMA's, the densest of VTK's.
constexpr std::uint64_t LargestCompression = 8192;

struct Messages
{
  std::vector<std::string> errors;
  Warnings warnings;
};

// VTK's messages read "ERROR: In file, line 1\nClass (0x1): text\n\n".
std::string TextOf(const char* message)
{
  std::string text = message;
  const std::size_t endOfPlace = text.find('\n');
  text = endOfPlace == std::string::npos ? text : text.substr(endOfPlace + 1);
  const std::size_t endOfClass = text.find("): ");
  return Trimmed(endOfClass == std::string::npos ? text : text.substr(endOfClass + 3));
}

void Collect(vtkObject*, unsigned long event, void* clientData, void* callData)
{
  auto* const messages = static_cast<Messages*>(clientData);
  auto& list = event == vtkCommand::ErrorEvent ? messages->errors : messages->warnings;
  list.push_back(TextOf(static_cast<const char*>(callData)));
}

// Hands out what reports errors of its own beside the reader. Unobserved, they would go to stderr.
class ObservableReader : public vtkXMLImageDataReader
{
public:
  static ObservableReader* New();
  vtkTypeMacro(ObservableReader, vtkXMLImageDataReader);

  void ObserveAll(vtkCommand* observer)
  {
    this->Observe(this, observer);
    this->Observe(this->GetExecutive(), observer);
    this->SetParserErrorObserver(observer);
  }

  /// The compressor is known once the header has been read.
  void ObserveCompressor(vtkCommand* observer)
  {
    if (this->XMLParser != nullptr)
    {
      this->Observe(this->XMLParser->GetCompressor(), observer);
    }
  }

private:
  void Observe(vtkObject* object, vtkCommand* observer)
  {
    if (object != nullptr)
    {
      object->AddObserver(vtkCommand::ErrorEvent, observer);
      object->AddObserver(vtkCommand::WarningEvent, observer);
    }
  }
};
vtkStandardNewMacro(ObservableReader);

void ThrowFirstError(const Messages& messages)
{
  if (!messages.errors.empty())
  {
    throw VolumeReadingError("VTK cannot read it: " + messages.errors.front());
  }
}

// What the header announces, before VTK asks for the memory for it.
void CheckAnnouncedSize(vtkXMLImageDataReader* reader, std::uint64_t fileSize)
{
  int extent[6];
  reader->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  VolumeGeometry announced;
  for (int axis = 0; axis < 3; ++axis)
  {
    announced.dimensions[axis] =
      static_cast<std::int64_t>(extent[2 * axis + 1]) - extent[2 * axis] + 1;
  }
  const std::uint64_t voxels = NumberOfVoxels(announced, sizeof(double));
  if (voxels / LargestCompression > fileSize)
  {
    throw VolumeReadingError("the file holds " + std::to_string(fileSize) + " bytes, too few for " +
      std::to_string(voxels) + " voxels, even compressed");
  }
  CheckMemory(voxels);
}

vtkDataArray* ScalarsOf(vtkImageData* image, Warnings& warnings)
{
  vtkPointData* const pointData = image->GetPointData();
  vtkDataArray* scalars = pointData->GetScalars();
  for (int i = 0; scalars == nullptr && i < pointData->GetNumberOfArrays(); ++i)
  {
    scalars = pointData->GetArray(i);
    if (scalars != nullptr)
    {
      warnings.push_back(std::string("its point data names no scalars; the array \"") +
        (scalars->GetName() ? scalars->GetName() : "") + "\" is read");
    }
  }
  if (scalars == nullptr || scalars->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    throw VolumeReadingError("it has no scalar for each point; an array in PointData is needed");
  }
  if (scalars->GetNumberOfComponents() != 1)
  {
    throw VolumeReadingError("it has " + std::to_string(scalars->GetNumberOfComponents()) +
      " values per voxel; one is needed");
  }
  if (std::string(ScalarTypeName(scalars->GetDataType())) == "unknown")
  {
    throw VolumeReadingError(std::string("its scalars are of type ") +
      scalars->GetDataTypeAsString() + "; a number of 8 to 64 bits is needed");
  }
  return scalars;
}

// The geometry with the index of the first voxel moved to (0, 0, 0).
VolumeGeometry GeometryOf(vtkImageData* image)
{
  VolumeGeometry geometry;
  const int* const dimensions = image->GetDimensions();
  std::copy_n(dimensions, 3, geometry.dimensions.begin());
  std::copy_n(image->GetSpacing(), 3, geometry.spacing.begin());
  std::copy_n(image->GetOrigin(), 3, geometry.origin.begin());
  const double* const direction = image->GetDirectionMatrix()->GetData();
  std::copy_n(direction, 9, geometry.direction.begin());
  CheckGeometry(geometry);

  const int* const extent = image->GetExtent();
  std::array<Vector3, 3> steps;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int row = 0; row < 3; ++row)
    {
      steps[axis][row] = direction[3 * row + axis] * geometry.spacing[axis];
      geometry.origin[row] += steps[axis][row] * extent[2 * axis];
    }
  }
  SetSteps(geometry, steps);
  return geometry;
}

}

Volume ReadXmlImageVolume(const std::filesystem::path& path, Warnings& warnings)
{
  Messages messages;
  vtkNew<vtkCallbackCommand> collector;
  collector->SetCallback(Collect);
  collector->SetClientData(&messages);
  vtkNew<ObservableReader> reader;
  reader->ObserveAll(collector);
  reader->SetFileName(path.u8string().c_str());
  reader->UpdateInformation();
  ThrowFirstError(messages);
  CheckAnnouncedSize(reader, SizeOfFile(path));
  reader->ObserveCompressor(collector);
  reader->Update();
  ThrowFirstError(messages);
  warnings.insert(warnings.end(), messages.warnings.begin(), messages.warnings.end());

  vtkImageData* const read = reader->GetOutput();
  const auto scalars = WithoutLongIntegers(ScalarsOf(read, warnings), warnings);
  auto image = Volume::New();
  ApplyGeometry(GeometryOf(read), image);
  image->GetPointData()->SetScalars(scalars);
  return image;
}

}
