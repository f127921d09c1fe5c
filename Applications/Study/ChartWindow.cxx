#include "ChartWindow.h"

#include "ChartMeasures.h"
#include "ChartText.h"
#include "vtkChartDrawing.h"

#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkPen.h>
#include <vtkPlotLine.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

namespace penumbra
{
namespace
{
void SetPen(vtkPen* pen, const ChartColor& color, double width)
{
  pen->SetColorF(color[0], color[1], color[2]);
  pen->SetWidth(static_cast<float>(width));
}

// Pixels are the coordinates of VTK's chart too, so that what it does to its coordinates (floats,
// shifts, scales) changes nothing.
class ScaledChart
{
public:
  ScaledChart(const ChartLayout& layout, int scale)
    : Layout(layout)
    , Scale(scale)
    , Sizes(layout.Size[0], layout.Size[1])
  {
  }

  vtkSmartPointer<vtkChartXY> Make() const
  {
    const ChartBox& plot = this->Layout.Plot;
    auto chart = vtkSmartPointer<vtkChartXY>::New();
    chart->SetLayoutStrategy(vtkChart::AXES_TO_RECT);
    chart->SetSize(vtkRectf(this->Times(plot.Left), this->Times(plot.Bottom),
      this->Times(plot.Width()), this->Times(plot.Height())));
    chart->SetAutoAxes(false);
    chart->SetRenderEmpty(true);
    chart->GetAxis(vtkAxis::TOP)->SetVisible(false);
    chart->GetAxis(vtkAxis::RIGHT)->SetVisible(false);
    this->SetUp(chart->GetAxis(vtkAxis::BOTTOM), this->Layout.XTicks, plot.Width());
    this->SetUp(chart->GetAxis(vtkAxis::LEFT), this->Layout.YTicks, plot.Height());
    for (const PlacedLines& lines : this->Layout.Curves)
    {
      if (!lines.Lines.empty())
      {
        chart->AddPlot(this->MakePlot(lines));
      }
    }
    return chart;
  }

private:
  float Times(double pixels) const { return static_cast<float>(this->Scale * pixels); }

  void SetUp(vtkAxis* axis, const std::vector<ChartTick>& ticks, double length) const
  {
    vtkNew<vtkDoubleArray> positions;
    vtkNew<vtkStringArray> labels;
    for (const ChartTick& tick : ticks)
    {
      if (!tick.Label.empty())
      {
        positions->InsertNextValue(this->Scale * tick.Position * length);
        labels->InsertNextValue(tick.Label);
      }
    }
    axis->SetBehavior(vtkAxis::FIXED);
    axis->SetRange(0.0, this->Scale * length);
    axis->SetCustomTickPositions(positions, labels);
    axis->SetTitleVisible(false);
    axis->SetTickLength(this->Times(this->Sizes.TickLength));
    axis->SetLabelOffset(this->Times(this->Sizes.TickLength + 0.3 * this->Sizes.Type));
    SetPen(axis->GetPen(), ChartQuietInk, this->Scale * this->Sizes.LineWidth);
    SetPen(axis->GetGridPen(), ChartGrid, this->Scale * this->Sizes.LineWidth);
    SetType(this->Sizes.Tick, this->Scale, axis->GetLabelProperties());
  }

  vtkSmartPointer<vtkPlotLine> MakePlot(const PlacedLines& lines) const
  {
    const ChartBox& plot = this->Layout.Plot;
    vtkNew<vtkFloatArray> x;
    vtkNew<vtkFloatArray> y;
    x->SetName("x");
    y->SetName("y");
    for (const ChartLineSegment& line : lines.Lines)
    {
      for (const ChartPlace& end : { line.From, line.To })
      {
        x->InsertNextValue(this->Times(end.X - plot.Left));
        y->InsertNextValue(this->Times(end.Y - plot.Bottom));
      }
    }
    vtkNew<vtkTable> table;
    table->AddColumn(x);
    table->AddColumn(y);
    auto plotLine = vtkSmartPointer<vtkPlotLine>::New();
    plotLine->SetInputData(table, 0, 1);
    plotLine->PolyLineOff();
    plotLine->SetMarkerStyle(vtkPlotPoints::NONE);
    SetPen(plotLine->GetPen(), lines.Color, this->Scale * lines.Width);
    return plotLine;
  }

  const ChartLayout& Layout;
  int Scale;
  ChartMeasures Sizes;
};
}

//------------------------------------------------------------------------------
ChartWindow::ChartWindow(const ChartLayout& layout, int scale)
{
  vtkNew<vtkChartDrawing> drawing;
  drawing->SetLayout(layout, scale);
  vtkNew<vtkContextActor> actor;
  actor->GetScene()->AddItem(ScaledChart(layout, scale).Make());
  actor->GetScene()->AddItem(drawing);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(ChartPaper[0], ChartPaper[1], ChartPaper[2]);
  renderer->SetBackgroundAlpha(1.0); // else the drawing has none
  renderer->AddActor(actor);
  actor->GetScene()->SetRenderer(renderer);
  this->Window->SetMultiSamples(0);
  this->Window->SetDPI(ChartDotsPerInch);
  this->Window->SetSize(scale * layout.Size[0], scale * layout.Size[1]);
  this->Window->AddRenderer(renderer);
  this->Window->Render();
}

}
