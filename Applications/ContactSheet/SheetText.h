/**
 * @file    SheetText.h
 * @brief   the type that a contact sheet is set in
 */

#ifndef SheetText_h
#define SheetText_h

#include <vtkSmartPointer.h>

#include <array>
#include <string>
#include <vector>

class vtkImageData;

namespace penumbra
{

struct TypeStyle
{
  /// Height of the type in pixels.
  int Size = 12;
  bool Bold = false;
  std::array<double, 3> Color{ 0.0, 0.0, 0.0 };
};

/// One line of text in one style.
struct TextLine
{
  std::string Text;
  TypeStyle Style;
};

/// From one line to the next in this style, in pixels.
int LineHeight(const TypeStyle& style);

/// How wide a line is, in pixels.
int WidthOf(const TextLine& line);

/**
 * The line in 8-bit RGBA, transparent where there is no ink; null where there is none at all. Lines
 * of one style have one height, and their baseline at one place in it.
 */
vtkSmartPointer<vtkImageData> RenderText(const TextLine& line);

/// A text with line breaks: its first line in one style, all others in another. An empty text has
/// no lines.
std::vector<TextLine> SplitLines(
  const std::string& text, const TypeStyle& first, const TypeStyle& others);

}

#endif
