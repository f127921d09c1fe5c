#include "Picture.h"

#include "InputError.h"
#include "RenderingError.h"

#include <vtkImageData.h>
#include <vtkImageExtractComponents.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>

namespace penumbra
{
namespace
{
constexpr int Channels = 4;

std::string EncodePng(vtkImageData* picture)
{
  vtkNew<vtkImageExtractComponents> colors;
  colors->SetInputData(ToBytes(picture));
  colors->SetComponents(0, 1, 2);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(colors->GetOutputPort());
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  return std::string(reinterpret_cast<const char*>(bytes->GetPointer(0)),
    static_cast<std::size_t>(bytes->GetNumberOfValues()));
}

bool IsBigEndian()
{
  const std::uint16_t one = 1;
  unsigned char first;
  std::memcpy(&first, &one, 1);
  return first == 0;
}

std::string EncodeMha(vtkImageData* picture)
{
  const int* size = picture->GetDimensions();
  const auto count = static_cast<std::size_t>(size[0]) * size[1] * Channels;
  std::vector<float> values(count);
  if (picture->GetScalarType() == VTK_FLOAT)
  {
    std::copy_n(static_cast<const float*>(picture->GetScalarPointer()), count, values.begin());
  }
  else
  {
    const auto* levels = static_cast<const unsigned char*>(picture->GetScalarPointer());
    std::transform(
      levels, levels + count, values.begin(), [](unsigned char level) { return level / 255.0f; });
  }
  std::string bytes = "ObjectType = Image\n"
                      "NDims = 2\n"
                      "BinaryData = True\n"
                      "BinaryDataByteOrderMSB = " +
    std::string(IsBigEndian() ? "True" : "False") +
    "\n"
    "CompressedData = False\n"
    "DimSize = " +
    std::to_string(size[0]) + " " + std::to_string(size[1]) +
    "\n"
    "ElementSpacing = 1 1\n"
    "ElementNumberOfChannels = 4\n"
    "ElementType = MET_FLOAT\n"
    "ElementDataFile = LOCAL\n";
  bytes.append(reinterpret_cast<const char*>(values.data()), count * sizeof(float));
  return bytes;
}
}

//------------------------------------------------------------------------------
PictureFormat FormatOf(const std::filesystem::path& file)
{
  std::string extension = file.extension().u8string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  if (extension == ".png")
  {
    return PictureFormat::Png;
  }
  if (extension == ".mha")
  {
    return PictureFormat::Mha;
  }
  throw InputError(
    "--output is " + file.u8string() + "; accepted: a name that ends in .png or .mha");
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ReadPicture(vtkRenderWindow* window)
{
  const int* size = window->GetSize();
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(size[0], size[1], 1);
  vtkNew<vtkUnsignedCharArray> levels;
  if (window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 0, levels) != VTK_OK ||
    levels->GetNumberOfValues() != Channels * picture->GetNumberOfPoints())
  {
    throw RenderingError("the picture could not be read from the window");
  }
  picture->GetPointData()->SetScalars(levels);
  return picture;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ToBytes(vtkImageData* picture)
{
  if (picture->GetScalarType() == VTK_UNSIGNED_CHAR)
  {
    return picture;
  }
  auto bytes = vtkSmartPointer<vtkImageData>::New();
  bytes->SetDimensions(picture->GetDimensions());
  bytes->AllocateScalars(VTK_UNSIGNED_CHAR, Channels);
  const auto* values = static_cast<const float*>(picture->GetScalarPointer());
  std::transform(values, values + Channels * picture->GetNumberOfPoints(),
    static_cast<unsigned char*>(bytes->GetScalarPointer()),
    [](float value)
    { return static_cast<unsigned char>(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f))); });
  return bytes;
}

//------------------------------------------------------------------------------
std::string EncodePicture(vtkImageData* picture, PictureFormat format)
{
  return format == PictureFormat::Png ? EncodePng(picture) : EncodeMha(picture);
}

}
