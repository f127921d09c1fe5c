/**
 * @class   vtkChartDrawing
 * @brief   what a chart of VTK lacks: markers of any shape, words beside points, a legend with both
 *
 * Paints the words, markers and lines of a ChartLayout but for its curves. Stands in the scene
 * after the chart.
 */

#ifndef vtkChartDrawing_h
#define vtkChartDrawing_h

#include "ChartLayout.h"

#include <vtkContextItem.h>

class vtkChartDrawing : public vtkContextItem
{
public:
  static vtkChartDrawing* New();
  vtkTypeMacro(vtkChartDrawing, vtkContextItem);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Each pixel of the layout becomes `scale` pixels.
  void SetLayout(const penumbra::ChartLayout& layout, double scale);

  bool Paint(vtkContext2D* painter) override;

protected:
  vtkChartDrawing() = default;
  ~vtkChartDrawing() override = default;

private:
  vtkChartDrawing(const vtkChartDrawing&) = delete;
  void operator=(const vtkChartDrawing&) = delete;

  void PaintLines(vtkContext2D* painter, const penumbra::PlacedLines& lines) const;
  void PaintMarker(vtkContext2D* painter, const penumbra::PlacedMarker& marker) const;
  void PaintText(vtkContext2D* painter, const penumbra::PlacedText& text) const;

  penumbra::ChartLayout Layout;
  double Scale = 1.0;
};

#endif
