#include "SheetPicture.h"

#include "InputError.h"
#include "SheetLayout.h"

#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkImageBlend.h>
#include <vtkImageData.h>
#include <vtkImageResize.h>
#include <vtkImageSincInterpolator.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
constexpr int LargestPicture = 16384;

using Level3 = std::array<unsigned char, 3>;
constexpr Level3 Paper{ 247, 246, 243 };
// Seen where a picture does not fill its cell.
constexpr Level3 Mat{ 235, 233, 228 };

vtkSmartPointer<vtkImageData> MakeUniform(const std::array<int, 2>& size, const Level3& color)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size[0], size[1], 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int channel = 0; channel < 3; ++channel)
  {
    image->GetPointData()->GetScalars()->FillComponent(channel, color[channel]);
  }
  return image;
}

vtkSmartPointer<vtkImageData> ReadPng(const std::filesystem::path& file)
{
  const std::string name = file.u8string();
  vtkNew<vtkPNGReader> reader;
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error) || !reader->CanReadFile(name.c_str()))
  {
    throw InputError(name + " cannot be read as a picture; accepted: a PNG file");
  }
  reader->SetFileName(name.c_str());
  reader->UpdateInformation();
  const int* extent = reader->GetDataExtent();
  if (reader->GetDataScalarType() != VTK_UNSIGNED_CHAR)
  {
    throw InputError(name + " has 16 bits per channel; accepted: 8");
  }
  if (extent[1] >= LargestPicture || extent[3] >= LargestPicture)
  {
    throw InputError(name + " has " + std::to_string(extent[1] + 1) + " x " +
      std::to_string(extent[3] + 1) + " pixels; accepted: at most " +
      std::to_string(LargestPicture) + " each way");
  }
  reader->Update();
  if (reader->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw InputError(name + " is damaged; accepted: a whole PNG file");
  }
  return reader->GetOutput();
}

vtkSmartPointer<vtkImageData> FitInto(
  const std::array<int, 2>& cellSize, const vtkSmartPointer<vtkImageData>& picture)
{
  const int* size = picture->GetDimensions();
  const double factor = std::min({ 1.0, cellSize[0] / static_cast<double>(size[0]),
    cellSize[1] / static_cast<double>(size[1]) });
  if (factor == 1.0)
  {
    return picture;
  }
  const auto scaled = [factor](int length)
  { return std::max(1, static_cast<int>(std::lround(factor * length))); };
  vtkNew<vtkImageSincInterpolator> smooth;
  smooth->AntialiasingOn();
  vtkNew<vtkImageResize> resize;
  resize->SetInputData(picture);
  resize->SetOutputDimensions(scaled(size[0]), scaled(size[1]), 1);
  resize->BorderOn(); // a pixel is an area, whose edges are scaled onto those of the cell
  resize->SetInterpolator(smooth);
  resize->Update();
  return resize->GetOutput();
}

class Sheet
{
public:
  explicit Sheet(const std::array<int, 2>& size)
    : Height(size[1])
  {
    this->Blend->AddInputData(MakeUniform(size, Paper));
  }

  void Add(vtkImageData* picture, const SheetPlace& place)
  {
    const int* size = picture->GetDimensions();
    const int bottom = this->Height - place.Top - size[1];
    picture->SetExtent(place.Left, place.Left + size[0] - 1, bottom, bottom + size[1] - 1, 0, 0);
    this->Blend->AddInputData(picture);
  }

  vtkSmartPointer<vtkImageData> Finish()
  {
    this->Blend->Update();
    return this->Blend->GetOutput();
  }

private:
  int Height;
  vtkNew<vtkImageBlend> Blend;
};

void AddCell(Sheet& sheet, const PlacedCell& cell, const std::array<int, 2>& cellSize)
{
  const auto picture = FitInto(cellSize, ReadPng(cell.Picture));
  const int* size = picture->GetDimensions();
  const bool isTransparent = picture->GetNumberOfScalarComponents() % 2 == 0;
  if (isTransparent || size[0] < cellSize[0] || size[1] < cellSize[1])
  {
    sheet.Add(MakeUniform(cellSize, Mat), cell.Place);
  }
  sheet.Add(picture,
    { cell.Place.Left + (cellSize[0] - size[0]) / 2,
      cell.Place.Top + (cellSize[1] - size[1]) / 2 });
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MakeSheetPicture(const SheetDescription& description)
{
  const SheetLayout layout = LayOut(description);
  Sheet sheet(layout.Size);
  for (const PlacedCell& cell : layout.Cells)
  {
    AddCell(sheet, cell, description.CellSize);
  }
  for (const PlacedText& text : layout.Texts)
  {
    if (const auto image = RenderText(text.Line))
    {
      sheet.Add(image, text.Place);
    }
  }
  return sheet.Finish();
}

}
