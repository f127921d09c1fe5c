/**
 * @class   WindowPanels
 * @brief   the panels around the 3D view
 */

#ifndef WindowPanels_h
#define WindowPanels_h

#include <QObject>
#include <Qt>

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

private:
  QDockWidget* Add(
    const QString& title, const QString& name, Qt::DockWidgetArea area, QWidget* content);
  QWidget* MakeRendering(QAction* dragClipping);
  void Arrange();
  void ShowPart(PipelinePart part);

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
};

}

#endif
