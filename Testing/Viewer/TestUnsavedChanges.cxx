#include "Catch.h"
#include "ImageComparison.h"
#include "ViewerSession.h"

#include <QApplication>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

#include <vtkImageData.h>

using namespace penumbra;

namespace
{
// Answers the next question, whenever it is asked.
class Answer : public QTimer
{
public:
  explicit Answer(QMessageBox::StandardButton button)
  {
    this->connect(this, &QTimer::timeout, this,
      [this, button]
      {
        if (auto* const box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget()))
        {
          this->stop();
          box->button(button)->click();
        }
      });
    this->start(20);
  }

  bool WasAsked() const { return !this->isActive(); }
};

void RemoveLights(ViewerSession& session)
{
  session.Document.Edit("edit", [](SceneDescription& scene) { scene.Lights.clear(); });
}
}

TEST_CASE("Changes that are not saved are asked about before the window closes")
{
  ViewerSession session;
  REQUIRE(session.Open(session.Files.File));
  RemoveLights(session);
  REQUIRE(session.Document.HasUnsavedChanges());
  const Answer cancel(QMessageBox::Cancel);
  CHECK_FALSE(session.Window.close());
  CHECK(session.Window.isVisible());
  const Answer discard(QMessageBox::Discard);
  CHECK(session.Window.close());
}

TEST_CASE("What was saved is not asked about, and a change that is undone neither")
{
  ViewerSession session;
  REQUIRE(session.Open(session.Files.File));
  RemoveLights(session);
  session.Window.Save(session.Files.PathOf("saved.json"));
  CHECK_FALSE(session.Document.HasUnsavedChanges());
  session.Document.GetHistory()->undo();
  CHECK(session.Document.HasUnsavedChanges());
  session.Document.GetHistory()->redo();
  CHECK_FALSE(session.Document.HasUnsavedChanges());
}

TEST_CASE("Edits that were made while another file was read are not lost unasked")
{
  ViewerSession session;
  REQUIRE(session.Open(session.Files.File));
  session.Window.Open(session.Files.PathOf("shells.mhd"));
  RemoveLights(session);
  const Answer cancel(QMessageBox::Cancel);
  REQUIRE(WaitFor([&] { return cancel.WasAsked(); }));
  CHECK(session.Document.GetOpenedFile() == session.Files.File);
  CHECK(session.Document.GetScene().Lights.empty());

  session.Window.Open(session.Files.PathOf("shells.mhd"));
  session.Document.GetHistory()->undo();
  session.Document.GetHistory()->redo();
  const Answer discard(QMessageBox::Discard);
  REQUIRE(WaitFor([&] { return discard.WasAsked(); }));
  CHECK(session.Document.GetName() == "shells.mhd");
}

TEST_CASE("What was discarded before another file is read is not asked about again")
{
  ViewerSession session;
  REQUIRE(session.Open(session.Files.File));
  RemoveLights(session);
  const Answer discard(QMessageBox::Discard);
  session.Window.OpenAsked(QString::fromStdString(session.Files.PathOf("shells.mhd")));
  REQUIRE(discard.WasAsked());
  const Answer again(QMessageBox::Cancel);
  CHECK(WaitFor([&] { return session.Document.GetName() == "shells.mhd"; }));
  CHECK_FALSE(again.WasAsked());
}

TEST_CASE("A scene that is saved is the same when it is opened again")
{
  ViewerSession session;
  REQUIRE(session.Open(session.Files.File));
  const auto before = session.TakePicture();
  session.Window.Save(session.Files.PathOf("saved.json"));
  REQUIRE(session.Open(session.Files.PathOf("saved.json")));
  CHECK(CompareImages(before, session.TakePicture()).rmse == 0.0);
}
