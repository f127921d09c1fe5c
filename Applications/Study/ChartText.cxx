#include "ChartText.h"

#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>
#include <cmath>

namespace penumbra
{

//------------------------------------------------------------------------------
std::string InTypeface(const std::string& text)
{
  std::string known;
  for (const char byte : text)
  {
    const bool continuesLetter = (static_cast<unsigned char>(byte) & 0xC0) == 0x80; // in UTF-8
    const bool isKnown = (byte >= ' ' && byte <= '~') || byte == '\n';
    if (!continuesLetter)
    {
      known += isKnown ? byte : '?';
    }
  }
  return known;
}

//------------------------------------------------------------------------------
TextLine FitInto(double width, const std::string& text, const TypeStyle& style)
{
  TextLine line{ InTypeface(text), style };
  std::replace(line.Text.begin(), line.Text.end(), '\n', ' ');
  if (WidthOf(line) <= width)
  {
    return line;
  }
  std::size_t fits = 0;
  std::size_t isTooLong = line.Text.size();
  const auto shortened = [&line](std::size_t length) {
    return TextLine{ line.Text.substr(0, length) + "...", line.Style };
  };
  while (fits + 1 < isTooLong)
  {
    const std::size_t middle = (fits + isTooLong) / 2;
    (WidthOf(shortened(middle)) <= width ? fits : isTooLong) = middle;
  }
  return shortened(fits);
}

//------------------------------------------------------------------------------
void SetType(const TypeStyle& style, double scale, vtkTextProperty* property)
{
  property->SetFontFamilyToArial();
  property->SetFontSize(static_cast<int>(std::lround(scale * style.Size)));
  property->SetBold(style.Bold);
  property->SetColor(style.Color[0], style.Color[1], style.Color[2]);

  // VTK keeps the first property with which it meets a style, to load its typeface from again when
  // there have been others in between. Met while painting, that would be the one that all texts
  // share, and letters of other styles would mix into the text.
  int bounds[4];
  vtkTextRenderer::GetInstance()->GetBoundingBox(property, "x", bounds, ChartDotsPerInch);
}

}
