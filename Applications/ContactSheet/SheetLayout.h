/**
 * @file    SheetLayout.h
 * @brief   where on a contact sheet everything stands
 */

#ifndef SheetLayout_h
#define SheetLayout_h

#include "SheetDescription.h"
#include "SheetText.h"

#include <array>
#include <vector>

namespace penumbra
{

/// In pixels from the sheet's upper left corner.
struct SheetPlace
{
  int Left = 0;
  int Top = 0;
};

struct PlacedText
{
  TextLine Line;
  SheetPlace Place;
};

struct PlacedCell
{
  std::filesystem::path Picture;
  SheetPlace Place;
};

struct SheetLayout
{
  std::array<int, 2> Size{ 0, 0 };
  std::vector<PlacedText> Texts;
  /// Row by row; all are as large as the description says.
  std::vector<PlacedCell> Cells;
};

/**
 * All columns are as wide as a cell, or as the widest text in any of them; all texts begin at the
 * left edge of what they belong to.
 * @throw InputError where the sheet would be too large for a picture.
 */
SheetLayout LayOut(const SheetDescription& sheet);

}

#endif
