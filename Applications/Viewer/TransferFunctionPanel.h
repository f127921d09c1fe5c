/**
 * @class   TransferFunctionPanel
 * @brief   the transfer function: its chart, its points as tables, and the gradient's part in it
 */

#ifndef TransferFunctionPanel_h
#define TransferFunctionPanel_h

#include <QTabWidget>

class QCheckBox;

namespace penumbra
{

class GradientOpacityChart;
class SceneDocument;
class TransferFunctionChart;

class TransferFunctionPanel : public QTabWidget
{
  Q_OBJECT
public:
  explicit TransferFunctionPanel(SceneDocument* document, QWidget* parent = nullptr);

  TransferFunctionChart* GetChart() { return this->Chart; }
  GradientOpacityChart* GetGradientChart() { return this->GradientChart; }

private:
  QWidget* MakePointPage();
  QWidget* MakeGradientPage();
  void SwitchGradient(bool on);
  void Refresh();

  SceneDocument* Document;
  TransferFunctionChart* Chart;
  GradientOpacityChart* GradientChart = nullptr;
  QCheckBox* GradientSwitch = nullptr;
  QWidget* GradientEditor = nullptr;
};

}

#endif
