#include "SheetPicture.h"

#include "InputError.h"
#include "SheetLayout.h"

#include <vtkDataArray.h>
#include <vtkImageBlend.h>
#include <vtkImageData.h>
#include <vtkImageResize.h>
#include <vtkImageSincInterpolator.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtk_png.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

namespace penumbra
{
namespace
{
constexpr unsigned int LargestPicture = 16384;

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

std::string ReadBytes(const std::filesystem::path& file)
{
  std::error_code error;
  std::ifstream stream(file, std::ios::binary);
  if (!stream || !std::filesystem::is_regular_file(file, error))
  {
    throw InputError(file.u8string() + " cannot be read; accepted: a PNG file");
  }
  return { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
}

// vtkPNGReader ends the program where a file is damaged.
class Decoder
{
public:
  explicit Decoder(const std::filesystem::path& file)
    : Name(file.u8string())
    , Bytes(ReadBytes(file))
  {
    this->Png.version = PNG_IMAGE_VERSION;
  }

  ~Decoder() { png_image_free(&this->Png); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  vtkSmartPointer<vtkImageData> Decode()
  {
    this->Check(
      png_image_begin_read_from_memory(&this->Png, this->Bytes.data(), this->Bytes.size()));
    this->RefuseTooLarge();
    this->Png.format = this->Png.format & PNG_FORMAT_FLAG_ALPHA ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
    this->Png.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;
    auto picture = vtkSmartPointer<vtkImageData>::New();
    picture->SetDimensions(
      static_cast<int>(this->Png.width), static_cast<int>(this->Png.height), 1);
    picture->AllocateScalars(
      VTK_UNSIGNED_CHAR, static_cast<int>(PNG_IMAGE_SAMPLE_CHANNELS(this->Png.format)));
    const auto rowLength = static_cast<png_int_32>(PNG_IMAGE_ROW_STRIDE(this->Png));
    const png_int_32 bottomRowFirst = -rowLength;
    this->Check(png_image_finish_read(
      &this->Png, nullptr, picture->GetScalarPointer(), bottomRowFirst, nullptr));
    return picture;
  }

private:
  void Check(int succeeded) const
  {
    if (!succeeded)
    {
      throw InputError(this->Name + " is no whole PNG file: " + this->Png.message);
    }
  }

  void RefuseTooLarge() const
  {
    if (this->Png.width > LargestPicture || this->Png.height > LargestPicture)
    {
      throw InputError(this->Name + " has " + std::to_string(this->Png.width) + " x " +
        std::to_string(this->Png.height) + " pixels; accepted: at most " +
        std::to_string(LargestPicture) + " each way");
    }
  }

  std::string Name;
  std::string Bytes;
  png_image Png{};
};

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
  const auto picture = FitInto(cellSize, Decoder(cell.Picture).Decode());
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
