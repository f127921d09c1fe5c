/**
 * @class   MainWindow
 * @brief   the viewer's window: the 3D view in the middle, panels around it
 */

#ifndef MainWindow_h
#define MainWindow_h

#include <QMainWindow>

#include <filesystem>
#include <memory>
#include <vector>

class QStackedLayout;

namespace penumbra
{

class AppearancePanel;
class FileActions;
class LightHandle;
class LightPanel;
class MessageBar;
class PictureActions;
class ReadingProgress;
class RecentFiles;
class SceneDocument;
class SceneOpening;
class StartPage;
class ViewHandles;
class VolumeView;
class WindowPanels;
struct OpenRequest;
struct OpenedScene;
struct SeriesFacts;

class MainWindow : public QMainWindow
{
  Q_OBJECT
public:
  /// `dicomParser` is the program penumbra-dicom-parser.
  explicit MainWindow(const std::filesystem::path& dicomParser, QWidget* parent = nullptr);
  ~MainWindow() override;

  /// Begins to read a scene, a volume or a folder.
  void Open(const std::filesystem::path& file);
  /// The same at a user's wish, who is asked about unsaved changes first.
  void OpenAsked(const QString& file);

  /// Writes the scene as it is seen. @throw InputError or RenderingError where that fails.
  void Save(const std::filesystem::path& file);

  void ShowError(const QString& text);

  /// Lets the first page offer a scene.
  void OfferExample(const std::filesystem::path& scene);

  /// Places and sizes of the window and its panels, from one start to the next.
  ///@{
  void RestoreLayout();
  void RememberLayout() const;
  ///@}

  SceneDocument* GetDocument() { return this->Document; }
  SceneOpening* GetOpening() { return this->Opening; }
  VolumeView* GetView() { return this->View; }
  LightPanel* GetLightPanel();
  LightHandle* GetLightHandle();
  AppearancePanel* GetAppearance();
  PictureActions* GetPictures() { return this->Pictures; }
  MessageBar* GetMessageBar() { return this->Messages; }

protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

private:
  void MakeMiddle();
  void Connect();
  OpenRequest MakeRequest(const std::filesystem::path& file) const;
  void Start(const OpenRequest& request);
  void ChooseSeries(OpenRequest request, const std::vector<SeriesFacts>& series);
  void ShowOpened(const std::shared_ptr<const OpenedScene>& scene);
  void ShowTitle();

  /// Whether there were edits since what is being read was asked for.
  bool EditedMeanwhile = false;
  SceneDocument* Document;
  SceneOpening* Opening;
  VolumeView* View;
  RecentFiles* Recent;
  FileActions* Files;
  PictureActions* Pictures;
  QStackedLayout* Stack = nullptr;
  StartPage* Page = nullptr;
  MessageBar* Messages = nullptr;
  ReadingProgress* Progress = nullptr;
  ViewHandles* Handles = nullptr;
  WindowPanels* Panels = nullptr;
};

}

#endif
