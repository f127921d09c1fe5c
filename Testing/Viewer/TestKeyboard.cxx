#include "Catch.h"
#include "ImageComparison.h"
#include "ViewerSession.h"

#include <QAction>
#include <QApplication>
#include <QTest>

#include <vtkImageData.h>

using namespace penumbra;

namespace
{
// What is seen changes by at least so many grey levels of 255.
constexpr double Seen = 2.0;

// A person without a mouse: keys go to what has the focus, and nowhere else.
struct KeyboardSession : ViewerSession
{
  KeyboardSession()
  {
    REQUIRE(this->Open(this->Files.File));
    this->Window.activateWindow();
    REQUIRE(WaitFor([] { return QApplication::focusWidget() != nullptr; }));
  }

  static void Press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
  {
    QTest::keyClick(QApplication::focusWidget(), key, modifiers);
  }

  // Tab by tab; more than there are controls is a circle.
  static bool TabTo(const QString& name)
  {
    constexpr int mostControls = 200;
    for (int i = 0; i < mostControls && QApplication::focusWidget()->objectName() != name; ++i)
    {
      Press(Qt::Key_Tab);
    }
    return QApplication::focusWidget()->objectName() == name;
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
