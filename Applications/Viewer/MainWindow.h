/**
 * @class   MainWindow
 * @brief   the viewer's window: the 3D view in the middle, panels around it
 */

#ifndef MainWindow_h
#define MainWindow_h

#include <QMainWindow>

#include <filesystem>
#include <memory>

namespace penumbra
{

class SceneDocument;
class SceneOpening;
class VolumeView;
struct OpenedScene;

class MainWindow : public QMainWindow
{
  Q_OBJECT
public:
  /// `dicomParser` is the program penumbra-dicom-parser.
  explicit MainWindow(const std::filesystem::path& dicomParser, QWidget* parent = nullptr);
  ~MainWindow() override;

  /// Begins to read a scene, a volume or a folder.
  void Open(const std::filesystem::path& file);

  /// Writes the scene as it is seen. @throw InputError or RenderingError where that fails.
  void Save(const std::filesystem::path& file);

  SceneDocument* GetDocument() { return this->Document; }
  SceneOpening* GetOpening() { return this->Opening; }
  VolumeView* GetView() { return this->View; }

private:
  void ShowOpened(const std::shared_ptr<const OpenedScene>& scene);

  SceneDocument* Document;
  SceneOpening* Opening;
  VolumeView* View;
};

}

#endif
