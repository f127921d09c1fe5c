/**
 * @class   TransferFunctionChart
 * @brief   opacity and colour over the values of the volume, to be edited by dragging points
 *
 * The upper chart has the opacity's points over the histogram, the lower one the colours'. A click
 * adds a point, dragging moves it, the Delete key removes it; a double click on a colour's point
 * changes the colour. Dragging with the right button moves all points (left, right) and stretches
 * them (up, down): level and window.
 */

#ifndef TransferFunctionChart_h
#define TransferFunctionChart_h

#include "ChartView.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

class vtkChartXY;
class vtkColorTransferControlPointsItem;
class vtkColorTransferFunction;
class vtkImageData;
class vtkPiecewiseControlPointsItem;
class vtkPiecewiseFunction;
class vtkPlot;

namespace penumbra
{

class SceneDocument;

class TransferFunctionChart : public ChartView
{
  Q_OBJECT
public:
  explicit TransferFunctionChart(SceneDocument* document, QWidget* parent = nullptr);
  ~TransferFunctionChart() override;

  vtkPiecewiseFunction* GetOpacity() { return this->Opacity; }
  vtkColorTransferFunction* GetColor() { return this->Color; }

protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void ArrangeCharts(float width, float height, float ratio) override;

private:
  void MakeCharts();
  void ShowOpened();
  void ShowScene();
  void TakeOpacity();
  void TakeColor();
  void ChooseColor();

  SceneDocument* Document;
  vtkNew<vtkChartXY> OpacityChart;
  vtkNew<vtkChartXY> ColorChart;
  vtkNew<vtkPiecewiseFunction> Opacity;
  vtkNew<vtkColorTransferFunction> Color;
  vtkNew<vtkPiecewiseControlPointsItem> OpacityPoints;
  vtkNew<vtkColorTransferControlPointsItem> ColorPoints;
  vtkSmartPointer<vtkPlot> Histogram;
  QPointF LastPlace;
  bool Showing = false;
};

}

#endif
