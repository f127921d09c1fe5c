/**
 * @file SheetOfColors.h
 * @brief A contact sheet of four pictures, each of one colour, and where colours and ink are in it.
 */
#ifndef SheetOfColors_h
#define SheetOfColors_h

#include "RunProgram.h"

#include <nlohmann/json.hpp>

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <functional>

namespace penumbra
{
using Color = std::array<int, 3>;

constexpr Color Red{ 200, 30, 20 };
constexpr Color Green{ 20, 170, 40 };
constexpr Color Blue{ 30, 40, 210 };
constexpr Color Violet{ 140, 20, 160 };

/// An image of one colour; of 4 components, transparent.
vtkSmartPointer<vtkImageData> MakeUniform(
  int width, int height, const Color& color, int components = 3);

/// Rows count from the top, as on a page.
Color ColorAt(vtkImageData* image, int x, int row);

struct Box
{
  int left = 1 << 20;
  int top = 1 << 20;
  int right = -1;
  int bottom = -1;
  int count = 0;

  int Width() const { return this->right - this->left + 1; }
  int Height() const { return this->bottom - this->top + 1; }
};

/// The box of the pixels that are meant, among those within bounds.
Box FindBox(vtkImageData* image, const std::function<bool(const Color&)>& isMeant,
  const Box* within = nullptr);

Box FindColor(vtkImageData* image, const Color& color);

/// What is darker than paper and no colour of a picture.
Box FindInk(vtkImageData* image, const Box& within);

/// A folder of two rows of two pictures of 100 x 80 pixels, and the sheet that shows them.
struct SheetOfColors : TemporaryFolder
{
  SheetOfColors();

  /// What the program makes of the sheet.
  vtkSmartPointer<vtkImageData> Make() const;
  ProgramResult Run() const;

  nlohmann::json Sheet;
};
}

#endif
