#include "vtkChartDrawing.h"

#include "ChartText.h"

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkTextProperty.h>

namespace
{
void Append(std::vector<float>& numbers, double x, double y)
{
  numbers.push_back(static_cast<float>(x));
  numbers.push_back(static_cast<float>(y));
}

int CountOf(const std::vector<float>& numbers)
{
  return static_cast<int>(numbers.size() / 2);
}
}

//------------------------------------------------------------------------------
vtkStandardNewMacro(vtkChartDrawing);

//------------------------------------------------------------------------------
void vtkChartDrawing::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Size: " << this->Layout.Size[0] << " x " << this->Layout.Size[1] << "\n";
  os << indent << "Scale: " << this->Scale << "\n";
  os << indent << "Lines: " << this->Layout.OtherLines.size() << "\n";
  os << indent << "Markers: " << this->Layout.Markers.size() << "\n";
  os << indent << "Texts: " << this->Layout.Texts.size() << "\n";
}

//------------------------------------------------------------------------------
void vtkChartDrawing::SetLayout(const penumbra::ChartLayout& layout, double scale)
{
  this->Layout = layout;
  this->Scale = scale;
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkChartDrawing::Paint(vtkContext2D* painter)
{
  for (const penumbra::PlacedLines& lines : this->Layout.OtherLines)
  {
    this->PaintLines(painter, lines);
  }
  for (const penumbra::PlacedMarker& marker : this->Layout.Markers)
  {
    this->PaintMarker(painter, marker);
  }
  for (const penumbra::PlacedText& text : this->Layout.Texts)
  {
    this->PaintText(painter, text);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkChartDrawing::PaintLines(vtkContext2D* painter, const penumbra::PlacedLines& lines) const
{
  std::vector<float> ends;
  for (const penumbra::ChartLineSegment& line : lines.Lines)
  {
    Append(ends, this->Scale * line.From.X, this->Scale * line.From.Y);
    Append(ends, this->Scale * line.To.X, this->Scale * line.To.Y);
  }
  vtkPen* pen = painter->GetPen();
  pen->SetLineType(vtkPen::SOLID_LINE);
  pen->SetColorF(lines.Color[0], lines.Color[1], lines.Color[2]);
  pen->SetOpacityF(1.0);
  pen->SetWidth(static_cast<float>(this->Scale * lines.Width));
  if (!ends.empty())
  {
    painter->DrawLines(ends.data(), CountOf(ends));
  }
}

//------------------------------------------------------------------------------
void vtkChartDrawing::PaintMarker(vtkContext2D* painter, const penumbra::PlacedMarker& marker) const
{
  // A rim of paper sets it off from lines and from other markers.
  constexpr double rim = 1.3;
  painter->GetPen()->SetLineType(vtkPen::NO_PEN);
  vtkBrush* brush = painter->GetBrush();
  brush->SetOpacityF(1.0);
  for (const bool isRim : { true, false })
  {
    const double radius = this->Scale * marker.Radius * (isRim ? rim : 1.0);
    const double x = this->Scale * marker.Place.X;
    const double y = this->Scale * marker.Place.Y;
    // OpenGL fills a fan from the first corner, so that this is the middle.
    std::vector<float> corners;
    Append(corners, x, y);
    for (const auto& corner : marker.Look.Marker)
    {
      Append(corners, x + radius * corner[0], y + radius * corner[1]);
    }
    corners.push_back(corners[2]);
    corners.push_back(corners[3]);
    const penumbra::ChartColor& color = isRim ? penumbra::ChartPaper : marker.Look.Color;
    brush->SetColorF(color[0], color[1], color[2]);
    painter->DrawPolygon(corners.data(), CountOf(corners));
  }
}

//------------------------------------------------------------------------------
void vtkChartDrawing::PaintText(vtkContext2D* painter, const penumbra::PlacedText& text) const
{
  vtkNew<vtkTextProperty> property;
  penumbra::SetType(text.Line.Style, this->Scale, property);
  property->SetVerticalJustificationToCentered();
  painter->ApplyTextProp(property);
  painter->DrawString(static_cast<float>(this->Scale * text.Place.X),
    static_cast<float>(this->Scale * text.Place.Y), text.Line.Text.c_str());
}
