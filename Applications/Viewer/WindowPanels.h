/**
 * @class   WindowPanels
 * @brief   the panels around the 3D view
 *
 * In a window that is narrow they share one column, as tabs, so that the view has room; once it is
 * wide again they are where they were.
 */

#ifndef WindowPanels_h
#define WindowPanels_h

#include <QByteArray>
#include <QObject>
#include <Qt>

#include <optional>

class QAction;
class QDockWidget;
class QMainWindow;
class QWidget;

namespace penumbra
{

class AppearancePanel;
class InformationPanel;
class LightPanel;
class SceneDocument;
class VolumeView;
enum class PipelinePart;

class WindowPanels : public QObject
{
  Q_OBJECT
public:
  /// Puts the panels into the window. `dragClipping`: see FillClippingForm.
  WindowPanels(
    QMainWindow* window, SceneDocument* document, VolumeView* view, QAction* dragClipping);

  InformationPanel* GetInformation() { return this->Information; }
  LightPanel* GetLights() { return this->Lights; }
  AppearancePanel* GetAppearance() { return this->Appearance; }

  /// The panels as they are arranged at first, for a menu.
  QList<QDockWidget*> GetDocks() const;

  /// As people arranged them in a wide window; see QMainWindow::saveState().
  ///@{
  QByteArray GetArrangement() const;
  void SetArrangement(const QByteArray& arrangement);
  ///@}

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  QDockWidget* Add(
    const QString& title, const QString& name, Qt::DockWidgetArea area, QWidget* content);
  QWidget* MakeRendering(QAction* dragClipping);
  void Arrange();
  void ArrangeInOneColumn();
  void FitWindow();
  QDockWidget* DockOf(PipelinePart part) const;
  void ShowSelected(PipelinePart part);
  void Show(PipelinePart part);

  QMainWindow* Window;
  SceneDocument* Document;
  VolumeView* View;
  InformationPanel* Information;
  LightPanel* Lights;
  AppearancePanel* Appearance;
  QDockWidget* PipelineDock;
  QDockWidget* InformationDock;
  QDockWidget* LightDock;
  QDockWidget* AppearanceDock;
  QDockWidget* RenderingDock;
  /// While they share a column: where they were.
  std::optional<QByteArray> WideArrangement;
};

}

#endif
