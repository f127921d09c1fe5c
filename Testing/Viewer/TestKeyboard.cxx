#include "Catch.h"
#include "ImageComparison.h"
#include "ViewerSession.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QTest>
#include <QTimer>

#include <vtkImageData.h>

using namespace penumbra;

namespace
{
// What is seen changes by at least so many grey levels of 255.
constexpr double Seen = 2.0;

// More tabs than there are controls are a circle.
constexpr int MostControls = 200;

// A person without a mouse: keys go to what has the focus, and nowhere else.
struct KeyboardSession : ViewerSession
{
  KeyboardSession()
  {
    REQUIRE(this->Open(this->Files.File));
    this->Activate();
  }

  // As a window manager does.
  void Activate()
  {
    this->Window.activateWindow();
    REQUIRE(WaitFor([] { return QApplication::focusWidget() != nullptr; }));
  }

  static void Press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
  {
    QTest::keyClick(QApplication::focusWidget(), key, modifiers);
  }

  // Tab by tab.
  static bool TabTo(const QString& name)
  {
    for (int i = 0; i < MostControls && QApplication::focusWidget()->objectName() != name; ++i)
    {
      Press(Qt::Key_Tab);
    }
    return QApplication::focusWidget()->objectName() == name;
  }

  // In the dialog that comes up: tab by tab to where a colour is written as #rrggbb.
  void ChooseColor(const QString& control, const QString& color)
  {
    REQUIRE(this->TabTo(control));
    QTimer::singleShot(0,
      [color]
      {
        auto* const dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        dialog->activateWindow();
        WaitFor([=] { return dialog->focusWidget() && dialog->focusWidget()->hasFocus(); }, 5.0);
        for (int i = 0; i < MostControls && !qobject_cast<QLineEdit*>(dialog->focusWidget()); ++i)
        {
          QTest::keyClick(dialog->focusWidget(), Qt::Key_Tab);
        }
        TypeText(qobject_cast<QLineEdit*>(dialog->focusWidget()), color);
        QTest::keyClick(dialog->focusWidget(), Qt::Key_Return);
      });
    this->Press(Qt::Key_Space);
    this->Activate();
  }

  const std::vector<LightDescription>& Lights() { return this->Document.GetScene().Lights; }
};
}

TEST_CASE("Lights are added, modified and removed by the keyboard alone", "[lights]")
{
  KeyboardSession session;
  const auto one = session.TakePicture();
  session.Press(Qt::Key_L, Qt::ControlModifier);
  REQUIRE(session.Lights().size() == 2);
  CHECK(session.ChangeSince(one) > Seen);

  const auto two = session.TakePicture();
  REQUIRE(session.TabTo("directionBall"));
  for (int i = 0; i < 8; ++i)
  {
    session.Press(Qt::Key_Right);
  }
  CHECK(session.ChangeSince(two) > Seen);

  const auto turned = session.TakePicture();
  REQUIRE(session.TabTo("Brightness"));
  QTest::keyClicks(QApplication::focusWidget(), "0.2");
  session.Press(Qt::Key_Return);
  CHECK(session.Lights()[1].Intensity == 0.2);
  CHECK(session.ChangeSince(turned) > Seen);
  REQUIRE(session.TabTo("Shadow"));
  session.Press(Qt::Key_Up);
  CHECK(session.Lights()[1].Shadow == ShadowKind::None);

  REQUIRE(session.TabTo("lightList"));
  session.Press(Qt::Key_Up);
  CHECK(session.Document.GetSelectedLight() == 0);
  session.Press(Qt::Key_Space);
  CHECK_FALSE(session.Lights()[0].On);

  session.Press(Qt::Key_L, Qt::ControlModifier | Qt::ShiftModifier);
  REQUIRE(session.Lights().size() == 1);
  CHECK(session.Lights()[0].Intensity == 0.2);
  session.Press(Qt::Key_L, Qt::ControlModifier | Qt::ShiftModifier);
  CHECK(session.Lights().empty());
  session.Press(Qt::Key_L, Qt::ControlModifier | Qt::ShiftModifier); // of none: nothing
  while (session.Find<QAction>("undo")->isEnabled())
  {
    session.Press(Qt::Key_Z, Qt::ControlModifier);
  }
  CHECK(session.ChangeSince(one) == 0.0);
}

TEST_CASE("Colours, shadow and place of a light are modified by the keyboard alone", "[lights]")
{
  KeyboardSession session;
  session.Document.Edit(
    "spot", [](SceneDescription& scene) { scene.Lights[0].Type = LightType::Point; });
  REQUIRE(session.TabTo("qt_tabwidget_tabbar"));
  session.Press(Qt::Key_Right);
  const auto& light = [&]() -> const LightDescription& { return session.Lights()[0]; };
  auto before = session.TakePicture();
  session.ChooseColor("Diffuse colour", "#ff0000");
  CHECK(light().Diffuse == Vector3{ 1.0, 0.0, 0.0 });
  CHECK(session.ChangeSince(before) > Seen);
  session.ChooseColor("Specular colour", "#00ff00");
  CHECK(light().Specular == Vector3{ 0.0, 1.0, 0.0 });
  session.ChooseColor("Ambient colour", "#0000ff");
  CHECK(light().Ambient == Vector3{ 0.0, 0.0, 1.0 });

  before = session.TakePicture();
  REQUIRE(session.TabTo("Position x"));
  TypeText(session.Find<QDoubleSpinBox>("Position x")->findChild<QLineEdit*>(), "40.5");
  session.Press(Qt::Key_Return);
  CHECK(light().Position[0] == 40.5);
  CHECK(session.ChangeSince(before) > Seen);
}
