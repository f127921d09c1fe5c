/**
 * @class   SceneDocument
 * @brief   the scene that is open: its description, voxels, history and file
 *
 * The description is the one truth of what is shown. It is always resolved and valid. Every change
 * of it is a step of the undo stack; the camera alone moves without one.
 */

#ifndef SceneDocument_h
#define SceneDocument_h

#include "SceneReading.h"

#include <QObject>
#include <QString>
#include <QUndoStack>

#include <functional>
#include <map>
#include <memory>
#include <optional>

namespace penumbra
{

class SceneDocument : public QObject
{
  Q_OBJECT
public:
  explicit SceneDocument(QObject* parent = nullptr);

  bool IsOpen() const { return this->Scene != nullptr; }
  /// Only where a scene is open.
  ///@{
  const SceneDescription& GetScene() const { return *this->Scene; }
  const SceneVoxels& GetVoxels() const { return this->Voxels; }
  /// As it was when it was opened.
  const SceneDescription& GetOpenedScene() const { return *this->SceneAsOpened; }
  ///@}

  /// What was opened, and where it was saved or loaded as a scene, if so.
  ///@{
  const std::filesystem::path& GetOpenedFile() const { return this->OpenedFile; }
  const std::optional<std::filesystem::path>& GetSceneFile() const { return this->SceneFile; }
  ///@}

  /// Of the file that the scene is saved as, or else of what was opened; empty where nothing is.
  QString GetName() const;

  /// Replaces what was open, and forgets its history.
  void Open(const OpenedScene& opened);

  /**
   * Changes a copy of the description and shows it. Nothing happens where the change leaves it as
   * it is. `gesture`: see SceneEdit.
   * @return what is wrong where the changed scene is not valid; the old one then stays.
   */
  QString Edit(const QString& text, const std::function<void(SceneDescription&)>& change,
    const QString& gesture = QString());

  /// The camera and size of the view, which are saved with the scene.
  void SetView(const CameraDescription& camera, const std::array<int, 2>& size);

  /**
   * Writes the scene and takes the file as its own. @throw InputError or RenderingError where it
   * cannot be written; what was there then stays.
   */
  void Save(const std::filesystem::path& file);

  bool HasUnsavedChanges() const { return this->IsOpen() && !this->History.isClean(); }
  QUndoStack* GetHistory() { return &this->History; }

  /// The light that is being edited; none: -1.
  ///@{
  int GetSelectedLight() const { return this->SelectedLight; }
  void SelectLight(int light);
  ///@}

  /// The clipping plane that is being edited; none: -1.
  ///@{
  int GetSelectedPlane() const { return this->SelectedPlane; }
  void SelectPlane(int plane);
  ///@}

signals:
  /// Another volume is shown.
  void opened();
  /// The description changed; also after opened().
  void changed();
  void lightSelected(int light);
  void planeSelected(int plane);
  /// An edit would have made a scene that is not valid.
  void refused(const QString& reason);
  /// The file that the scene is saved as changed.
  void fileChanged();

private:
  using SharedScene = std::shared_ptr<const SceneDescription>;
  void Show(const SharedScene& scene);
  /// Images that were read once stay, so that no step of the history can fail.
  const EnvironmentImages& FindEnvironment(const MaterialDescription& material);

  SharedScene Scene;
  SharedScene SceneAsOpened;
  SceneVoxels Voxels;
  std::map<std::vector<std::filesystem::path>, EnvironmentImages> Environments;
  std::filesystem::path OpenedFile;
  std::optional<std::filesystem::path> SceneFile;
  QUndoStack History;
  int SelectedLight = -1;
  int SelectedPlane = -1;
};

}

#endif
