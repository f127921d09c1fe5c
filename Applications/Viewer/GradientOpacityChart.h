/**
 * @class   GradientOpacityChart
 * @brief   the factor of opacity over the gradient's length, to be edited by dragging points
 *
 * Behind the points is the histogram of the volume's gradients, which is made when it is first
 * seen.
 */

#ifndef GradientOpacityChart_h
#define GradientOpacityChart_h

#include "ChartView.h"

#include <vtkSmartPointer.h>

class vtkImageData;
class vtkPiecewiseControlPointsItem;
class vtkPiecewiseFunction;
class vtkPlot;

namespace penumbra
{

class SceneDocument;

/// Where the chart's axis ends, in the volume's values per voxel.
double LargestGradientOfChart(vtkImageData* volume);

class GradientOpacityChart : public ChartView
{
  Q_OBJECT
public:
  explicit GradientOpacityChart(SceneDocument* document, QWidget* parent = nullptr);
  ~GradientOpacityChart() override;

  vtkPiecewiseFunction* GetFunction() { return this->Function; }

protected:
  void ArrangeCharts(float width, float height, float ratio) override;
  void showEvent(QShowEvent* event) override;

private:
  void ShowOpened();
  void ShowHistogram();
  void ShowScene();
  void TakeFunction();

  SceneDocument* Document;
  vtkNew<vtkChartXY> Chart;
  vtkNew<vtkPiecewiseFunction> Function;
  vtkNew<vtkPiecewiseControlPointsItem> Points;
  vtkSmartPointer<vtkPlot> Histogram;
  bool Showing = false;
};

}

#endif
