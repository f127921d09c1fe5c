#include "SheetText.h"

#include <vtkFreeTypeStringToImage.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkVector.h>

#include <sstream>

namespace penumbra
{
namespace
{
// At which a size in points is one in pixels.
constexpr int DotsPerInch = 72;

void Apply(const TypeStyle& style, vtkTextProperty* property)
{
  property->SetFontFamilyToArial();
  property->SetFontSize(style.Size);
  property->SetBold(style.Bold);
  property->SetColor(style.Color[0], style.Color[1], style.Color[2]);
}

vtkVector2i BoundsOf(const TextLine& line)
{
  vtkNew<vtkTextProperty> property;
  Apply(line.Style, property);
  vtkNew<vtkFreeTypeStringToImage> type;
  return type->GetBounds(property, vtkStdString(line.Text), DotsPerInch);
}
}

//------------------------------------------------------------------------------
int LineHeight(const TypeStyle& style)
{
  constexpr double leading = 1.25;
  return static_cast<int>(leading * (BoundsOf({ "x", style })[1] + 1));
}

//------------------------------------------------------------------------------
int WidthOf(const TextLine& line)
{
  return line.Text.empty() ? 0 : BoundsOf(line)[0] + 1;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> RenderText(const TextLine& line)
{
  if (line.Text.empty())
  {
    return nullptr;
  }
  vtkNew<vtkTextProperty> property;
  Apply(line.Style, property);
  vtkNew<vtkFreeTypeStringToImage> type;
  type->SetScaleToPowerOfTwo(false);
  auto image = vtkSmartPointer<vtkImageData>::New();
  return type->RenderString(property, vtkStdString(line.Text), DotsPerInch, image) ? image
                                                                                   : nullptr;
}

//------------------------------------------------------------------------------
std::vector<TextLine> SplitLines(
  const std::string& text, const TypeStyle& first, const TypeStyle& others)
{
  std::vector<TextLine> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
  {
    lines.push_back({ line, lines.empty() ? first : others });
  }
  return lines;
}

}
