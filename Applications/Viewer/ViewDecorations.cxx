#include "ViewDecorations.h"

#include <vtkActor2D.h>
#include <vtkAnnotatedCubeActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkMath.h>
#include <vtkOrientationMarkerWidget.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace penumbra
{
namespace
{
// Of the view: how wide the bar may be; and in pixels where it stands.
constexpr double LargestPart = 0.25;
constexpr double Margin = 18.0;
constexpr double Tick = 5.0;
constexpr double Grey = 0.85;

std::string ToText(double number)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << number;
  return text.str();
}
}

//------------------------------------------------------------------------------
double RoundLength(double length)
{
  const double power = std::pow(10.0, std::floor(std::log10(length)));
  const double first = length / power;
  return power * (first >= 5.0 ? 5.0 : first >= 2.0 ? 2.0 : 1.0);
}

//------------------------------------------------------------------------------
ViewDecorations::ViewDecorations(vtkRenderWindowInteractor* interactor)
{
  this->Cube->GetCubeProperty()->SetColor(0.30, 0.36, 0.45);
  this->Cube->GetTextEdgesProperty()->SetColor(Grey, Grey, Grey);
  this->Cube->SetFaceTextScale(0.6);
  for (vtkProperty* face :
    { this->Cube->GetXPlusFaceProperty(), this->Cube->GetXMinusFaceProperty(),
      this->Cube->GetYPlusFaceProperty(), this->Cube->GetYMinusFaceProperty(),
      this->Cube->GetZPlusFaceProperty(), this->Cube->GetZMinusFaceProperty() })
  {
    face->SetColor(1.0, 1.0, 1.0);
  }
  this->Marker->SetOrientationMarker(this->Cube);
  this->Marker->SetInteractor(interactor);
  this->Marker->SetViewport(0.0, 0.0, 0.16, 0.18);

  vtkNew<vtkPolyData> lines;
  lines->SetPoints(this->BarPoints);
  this->BarPoints->SetNumberOfPoints(4);
  vtkNew<vtkCellArray> cells;
  const vtkIdType path[] = { 0, 1, 2, 3 };
  cells->InsertNextCell(4, path);
  lines->SetLines(cells);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(lines);
  this->Bar->SetMapper(mapper);
  this->Bar->GetProperty()->SetColor(Grey, Grey, Grey);
  this->Bar->GetProperty()->SetLineWidth(2.0f);
  this->BarText->GetTextProperty()->SetColor(Grey, Grey, Grey);
  this->BarText->GetTextProperty()->SetFontSize(14);
  this->BarText->GetTextProperty()->SetJustificationToRight();
}

//------------------------------------------------------------------------------
ViewDecorations::~ViewDecorations()
{
  this->Detach();
}

//------------------------------------------------------------------------------
void ViewDecorations::SetLetters(bool isPatient)
{
  this->Cube->SetXPlusFaceText(isPatient ? "L" : "X");
  this->Cube->SetXMinusFaceText(isPatient ? "R" : "-X");
  this->Cube->SetYPlusFaceText(isPatient ? "P" : "Y");
  this->Cube->SetYMinusFaceText(isPatient ? "A" : "-Y");
  this->Cube->SetZPlusFaceText(isPatient ? "S" : "Z");
  this->Cube->SetZMinusFaceText(isPatient ? "I" : "-Z");
  // Letters stand upright with the head up, and from above and below with the front up.
  this->Cube->SetZFaceTextRotation(90.0);
  this->Cube->SetXFaceTextRotation(0.0);
  this->Cube->SetYFaceTextRotation(0.0);
}

//------------------------------------------------------------------------------
void ViewDecorations::Attach(vtkRenderer* renderer, bool isPatient, const std::string& unit)
{
  this->Detach();
  this->Renderer = renderer;
  this->Unit = unit;
  this->SetLetters(isPatient);
  this->Marker->SetDefaultRenderer(renderer);
  renderer->AddActor2D(this->Bar);
  renderer->AddActor2D(this->BarText);
  this->Refresh();
}

//------------------------------------------------------------------------------
void ViewDecorations::Detach()
{
  if (this->Renderer)
  {
    this->Marker->SetEnabled(false);
    this->Renderer->RemoveActor2D(this->Bar);
    this->Renderer->RemoveActor2D(this->BarText);
    this->Renderer = nullptr;
  }
}

//------------------------------------------------------------------------------
void ViewDecorations::ShowOrientation(bool shown)
{
  this->OrientationShown = shown;
  this->Refresh();
}

//------------------------------------------------------------------------------
void ViewDecorations::ShowScaleBar(bool shown)
{
  this->ScaleBarShown = shown;
  this->Refresh();
}

//------------------------------------------------------------------------------
void ViewDecorations::Hide(bool hidden)
{
  this->Hidden = hidden;
  this->Refresh();
}

//------------------------------------------------------------------------------
void ViewDecorations::Refresh()
{
  if (!this->Renderer)
  {
    return;
  }
  const bool hasMarker = this->OrientationShown && !this->Hidden;
  this->Marker->SetEnabled(hasMarker);
  if (hasMarker)
  {
    this->Marker->InteractiveOff();
  }
  const bool hasBar = this->ScaleBarShown && !this->Hidden;
  this->Bar->SetVisibility(hasBar);
  this->BarText->SetVisibility(hasBar);
}

//------------------------------------------------------------------------------
void ViewDecorations::FitScaleBar()
{
  if (!this->Renderer || !this->ScaleBarShown)
  {
    return;
  }
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const int* size = this->Renderer->GetRenderWindow()->GetSize();
  const double half = camera->GetParallelProjection()
    ? camera->GetParallelScale()
    : camera->GetDistance() * std::tan(vtkMath::RadiansFromDegrees(camera->GetViewAngle()) / 2.0);
  const double lengthOfPixel = 2.0 * half / std::max(size[1], 1);
  const double length = RoundLength(LargestPart * size[0] * lengthOfPixel);
  const double right = size[0] - Margin;
  const double left = right - length / lengthOfPixel;
  this->BarPoints->SetPoint(0, left, Margin + Tick, 0.0);
  this->BarPoints->SetPoint(1, left, Margin, 0.0);
  this->BarPoints->SetPoint(2, right, Margin, 0.0);
  this->BarPoints->SetPoint(3, right, Margin + Tick, 0.0);
  this->BarPoints->Modified();
  this->BarText->SetInput((ToText(length) + (this->Unit.empty() ? "" : " " + this->Unit)).c_str());
  this->BarText->SetPosition(right, Margin + 2.0 * Tick);
}

}
