#include "SheetOfColors.h"

#include "Catch.h"
#include "ImageComparison.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>

namespace penumbra
{
vtkSmartPointer<vtkImageData> MakeUniform(int width, int height, const Color& color, int components)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  for (int channel = 0; channel < components; ++channel)
  {
    image->GetPointData()->GetScalars()->FillComponent(channel, channel < 3 ? color[channel] : 0);
  }
  return image;
}

Color ColorAt(vtkImageData* image, int x, int row)
{
  const int y = image->GetDimensions()[1] - 1 - row;
  const auto* levels = static_cast<const unsigned char*>(image->GetScalarPointer(x, y, 0));
  return { levels[0], levels[1], levels[2] };
}

Box FindBox(
  vtkImageData* image, const std::function<bool(const Color&)>& isMeant, const Box* within)
{
  const int* size = image->GetDimensions();
  Box box;
  for (int row = within ? within->top : 0; row <= (within ? within->bottom : size[1] - 1); ++row)
  {
    for (int x = within ? within->left : 0; x <= (within ? within->right : size[0] - 1); ++x)
    {
      if (isMeant(ColorAt(image, x, row)))
      {
        box.left = std::min(box.left, x);
        box.right = std::max(box.right, x);
        box.top = std::min(box.top, row);
        box.bottom = std::max(box.bottom, row);
        ++box.count;
      }
    }
  }
  return box;
}

Box FindColor(vtkImageData* image, const Color& color)
{
  return FindBox(image, [&color](const Color& other) { return other == color; });
}

Box FindInk(vtkImageData* image, const Box& within)
{
  return FindBox(
    image,
    [](const Color& color)
    {
      const auto [least, most] = std::minmax_element(color.begin(), color.end());
      return *most < 200 && *most - *least < 30;
    },
    &within);
}

SheetOfColors::SheetOfColors()
{
  WritePNG(MakeUniform(100, 80, Red), this->PathOf("red.png"));
  WritePNG(MakeUniform(100, 80, Green), this->PathOf("green.png"));
  WritePNG(MakeUniform(100, 80, Blue), this->PathOf("blue.png"));
  WritePNG(MakeUniform(100, 80, Violet), this->PathOf("violet.png"));
  this->Sheet =
    nlohmann::json::parse(R"({ "columns": ["One", "Two"], "cellSize": [100, 80], "rows": [
    { "title": "Upper", "cells": [{ "picture": "red.png", "caption": "1 x" },
                                  { "picture": "green.png", "caption": "2 x\n0.3 s" }] },
    { "title": "Lower", "cells": [{ "picture": "blue.png", "caption": "3 x" },
                                  { "picture": "violet.png", "caption": "4 x" }] }] })");
}

vtkSmartPointer<vtkImageData> SheetOfColors::Make() const
{
  const auto result = this->Run();
  INFO(result.error);
  REQUIRE(result.exitStatus == 0);
  CHECK(result.error.empty());
  return ReadPNG(this->PathOf("sheet.png"));
}

ProgramResult SheetOfColors::Run() const
{
  this->Write("sheet.json", this->Sheet.dump());
  return RunProgram(
    { PENUMBRA_CONTACT_SHEET, this->PathOf("sheet.json"), "--output", this->PathOf("sheet.png") });
}
}
