/**
 * @class   GradientOpacityChart
 * @brief   the factor of opacity over the gradient's length, to be edited by dragging points
 */

#ifndef GradientOpacityChart_h
#define GradientOpacityChart_h

#include "ChartView.h"

class vtkImageData;
class vtkPiecewiseControlPointsItem;
class vtkPiecewiseFunction;

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

private:
  void ShowOpened();
  void ShowScene();
  void TakeFunction();

  SceneDocument* Document;
  vtkNew<vtkChartXY> Chart;
  vtkNew<vtkPiecewiseFunction> Function;
  vtkNew<vtkPiecewiseControlPointsItem> Points;
  bool Showing = false;
};

}

#endif
