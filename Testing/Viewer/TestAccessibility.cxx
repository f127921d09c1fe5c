#include "Catch.h"
#include "ImageComparison.h"
#include "ViewerSession.h"

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollBar>
#include <QTimer>

#include <vtkImageData.h>

using namespace penumbra;

namespace
{
// Parts that Qt makes and names itself.
bool IsQtsOwn(const QWidget* widget)
{
  return widget->objectName().startsWith("qt_") || qobject_cast<const QScrollBar*>(widget) ||
    QString(widget->metaObject()->className()).startsWith("QComboBoxPrivate") ||
    QString(widget->metaObject()->className()) == "QTableCornerButton" ||
    (widget->parentWidget() &&
      (qobject_cast<const QAbstractSpinBox*>(widget->parentWidget()) ||
        qobject_cast<const QComboBox*>(widget->parentWidget())));
}

bool IsControl(const QWidget* widget)
{
  return qobject_cast<const QAbstractButton*>(widget) ||
    qobject_cast<const QAbstractSlider*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget) ||
    qobject_cast<const QComboBox*>(widget) || qobject_cast<const QLineEdit*>(widget);
}

bool HasName(const QWidget* widget)
{
  const auto* const button = qobject_cast<const QAbstractButton*>(widget);
  return !widget->accessibleName().isEmpty() || (button && !button->text().isEmpty());
}

void AnswerNextQuestion(QMessageBox::StandardButton answer)
{
  QTimer::singleShot(300,
    [answer]
    {
      auto* const box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      REQUIRE(box);
      box->button(answer)->click();
    });
}
}

TEST_CASE("Every control has a name for screen readers and is reached by the keyboard")
{
  ViewerSession session;
  REQUIRE(session.Open(session.Files.File));
  int controls = 0;
  for (const QWidget* widget : session.Window.findChildren<QWidget*>())
  {
    if (IsControl(widget) && !IsQtsOwn(widget))
    {
      CAPTURE(widget->metaObject()->className(), widget->objectName().toStdString());
      CHECK(HasName(widget));
      ++controls;
    }
  }
  CHECK(controls > 50); // of the panels alone
  CHECK(session.Window.findChild<QWidget*>("directionBall")->focusPolicy() == Qt::StrongFocus);
}

TEST_CASE("Changes that are not saved are asked about before the window closes")
{
  ViewerSession session;
  REQUIRE(session.Open(session.Files.File));
  session.Document.Edit("edit", [](SceneDescription& scene) { scene.Lights.clear(); });
  REQUIRE(session.Document.HasUnsavedChanges());
  AnswerNextQuestion(QMessageBox::Cancel);
  CHECK_FALSE(session.Window.close());
  CHECK(session.Window.isVisible());
  AnswerNextQuestion(QMessageBox::Discard);
  CHECK(session.Window.close());
}

TEST_CASE("What was saved is not asked about, and a change that is undone neither")
{
  ViewerSession session;
  REQUIRE(session.Open(session.Files.File));
  session.Document.Edit("edit", [](SceneDescription& scene) { scene.Lights.clear(); });
  session.Window.Save(session.Files.PathOf("saved.json"));
  CHECK_FALSE(session.Document.HasUnsavedChanges());
  session.Document.GetHistory()->undo();
  CHECK(session.Document.HasUnsavedChanges());
  session.Document.GetHistory()->redo();
  CHECK_FALSE(session.Document.HasUnsavedChanges());
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
