/**
 * @file    ViewerSession.h
 * @brief   the viewer's main window with a small scene, for tests
 */

#ifndef ViewerSession_h
#define ViewerSession_h

#include "Catch.h"
#include "MainWindow.h"
#include "SceneDocument.h"
#include "SceneOpening.h"
#include "TemporaryFolder.h"
#include "VolumeView.h"
#include "WaitFor.h"

#include <string>

class QLineEdit;

namespace penumbra
{

/// Replaces a line's text as the keyboard does, letter by letter.
void TypeText(QLineEdit* line, const QString& text);

/// A folder with a scene of shells around a ball, 32 voxels wide, under one shadowing light.
class ShellsScene : public TemporaryFolder
{
public:
  ShellsScene();

  std::string File;
};

class ViewerSession
{
public:
  ViewerSession();

  /// Reads and shows a file. Returns whether it is shown; else GetReason() says why not.
  bool Open(const std::string& file);
  const std::string& GetReason() const { return this->Reason; }

  /// The whole picture of the scene as it is now.
  vtkSmartPointer<vtkImageData> TakePicture();

  /// How far it is from an earlier picture, as a root mean square of 255 grey levels.
  double ChangeSince(vtkImageData* before);

  /// Presses the left button at a place of the scene, moves to another and lets go.
  void DragInView(const Vector3& from, const Vector3& to);

  template <typename Type>
  Type* Find(const QString& name)
  {
    auto* const found = this->Window.findChild<Type*>(name);
    REQUIRE(found);
    return found;
  }

  ShellsScene Files;
  MainWindow Window;
  SceneDocument& Document;

private:
  std::string Reason;
};

/// What penumbra-render makes of a scene file.
vtkSmartPointer<vtkImageData> RenderScene(const std::string& file, const TemporaryFolder& folder);

}

#endif
