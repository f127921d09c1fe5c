/**
 * @class   ChartView
 * @brief   a widget with VTK's charts in the colours of the theme
 */

#ifndef ChartView_h
#define ChartView_h

#include <QVTKOpenGLNativeWidget.h>

#include <vtkNew.h>

#include <vector>

class vtkChartXY;
class vtkContextActor;
class vtkGenericOpenGLRenderWindow;
class vtkRenderer;

namespace penumbra
{

class ChartView : public QVTKOpenGLNativeWidget
{
  Q_OBJECT
public:
  explicit ChartView(QWidget* parent = nullptr);
  ~ChartView() override;

protected:
  /// Of the space around the charts and of the one for an axis' numbers, in pixels of a coarse
  /// screen.
  ///@{
  static constexpr float Border = 18.0f;
  static constexpr float AxisHeight = 22.0f;
  ///@}

  /// Adds a chart that has its plots: they show the axes that they are added to.
  void AddChart(vtkChartXY* chart, bool numbered);

  /// Places the charts in a window of this size; `ratio` is its pixels per coarse one.
  virtual void ArrangeCharts(float width, float height, float ratio) = 0;

  /// Draws anew, once it is seen.
  void Draw();

  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

private:
  void Arrange();
  void ApplyTheme();

  vtkNew<vtkGenericOpenGLRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkContextActor> Actor;
  std::vector<vtkChartXY*> Numbered;
  bool Outdated = false;
};

}

#endif
