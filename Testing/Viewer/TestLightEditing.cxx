#include "Catch.h"
#include "DirectionBall.h"
#include "ImageComparison.h"
#include "LightPanel.h"
#include "ViewerSession.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>

#include <vtkImageData.h>

using namespace penumbra;

namespace
{
// What a light that is seen changes at least; pictures that are the same differ by nothing.
constexpr double Seen = 2.0;

struct LightSession : ViewerSession
{
  LightSession() { REQUIRE(this->Open(this->Files.File)); }

  std::size_t CountLights() { return this->Document.GetScene().Lights.size(); }
  const LightDescription& Light(std::size_t i) { return this->Document.GetScene().Lights[i]; }
};
}

TEST_CASE("A light is added, and the picture follows", "[lights]")
{
  LightSession session;
  const auto before = session.TakePicture();
  for (int type = 0; type < 4; ++type)
  {
    session.Find<QAction>("addLight" + QString::number(type))->trigger();
    CAPTURE(type);
    REQUIRE(session.CountLights() == 2);
    CHECK(static_cast<int>(session.Light(1).Type) == type);
    CHECK(session.Document.GetSelectedLight() == 1);
    CHECK(session.ChangeSince(before) > Seen);
    session.Find<QAction>("undo")->trigger();
    CHECK(session.CountLights() == 1);
    CHECK(session.ChangeSince(before) == 0.0);
  }
}

TEST_CASE("Lights are removed until none is left, and then removal is disabled", "[lights]")
{
  LightSession session;
  const auto before = session.TakePicture();
  auto* const remove = session.Find<QAction>("removeLight");
  auto* const button = session.Find<QAbstractButton>("removeLightButton");
  REQUIRE(remove->isEnabled());
  REQUIRE(button->isEnabled());
  button->click();
  CHECK(session.CountLights() == 0);
  CHECK(session.ChangeSince(before) > Seen);
  CHECK_FALSE(remove->isEnabled());
  CHECK_FALSE(button->isEnabled());
  CHECK(session.Find<QLabel>("lightHint")->text().startsWith("There is no light"));
  session.Find<QAction>("undo")->trigger();
  CHECK(session.CountLights() == 1);
  CHECK(remove->isEnabled());
  CHECK(session.ChangeSince(before) == 0.0);
  session.Find<QAction>("redo")->trigger();
  CHECK(session.CountLights() == 0);
}

TEST_CASE("The ball turns the selected light by mouse and by keyboard", "[lights]")
{
  LightSession session;
  auto* const ball = session.Find<DirectionBall>("directionBall");
  const auto before = session.TakePicture();
  emit ball->edited(UnitVector({ 1.0, 0.0, 1.0 }));
  CHECK(session.ChangeSince(before) > Seen);
  // The light now comes from the right in the view, and the ball shows it.
  CHECK(ball->GetDirection()[0] == Approx(std::sqrt(0.5)));
  CHECK(ball->GetDirection()[1] == Approx(0.0).margin(1e-9));
  session.Find<QAction>("undo")->trigger();
  CHECK(session.ChangeSince(before) == 0.0);
  for (int i = 0; i < 6; ++i)
  {
    QKeyEvent key(QEvent::KeyPress, Qt::Key_Up, Qt::NoModifier);
    QApplication::sendEvent(ball, &key);
  }
  CHECK(session.Document.GetHistory()->index() == 1); // one gesture, one step
  CHECK(session.ChangeSince(before) > Seen);
  session.Find<QDoubleSpinBox>("Brightness")->setValue(0.5);
  CHECK(session.Document.GetHistory()->index() == 2); // another gesture, however soon
}

TEST_CASE("Brightness takes numbers with a point or a comma in every language", "[lights]")
{
  LightSession session;
  const auto before = session.TakePicture();
  QLocale::setDefault(QLocale(QLocale::German));
  auto* const box = session.Find<QDoubleSpinBox>("Brightness");
  for (const char* text : { "0.5", "0,5" })
  {
    box->setValue(1.0);
    TypeText(box->findChild<QLineEdit*>(), text);
    box->interpretText();
    CAPTURE(text);
    CHECK(session.Light(0).Intensity == 0.5);
    CHECK(box->text() == "0.5");
  }
  QLocale::setDefault(QLocale::c());
  CHECK(session.ChangeSince(before) > Seen);
}

TEST_CASE("Shadows and switches of lights are seen", "[lights]")
{
  LightSession session;
  const auto soft = session.TakePicture();
  auto* const shadow = session.Find<QComboBox>("Shadow");
  shadow->setCurrentIndex(0);
  emit shadow->activated(0);
  CHECK(session.Light(0).Shadow == ShadowKind::None);
  CHECK(session.ChangeSince(soft) > Seen);
  session.Find<QListWidget>("lightList")->item(0)->setCheckState(Qt::Unchecked);
  CHECK_FALSE(session.Light(0).On);
  CHECK(session.ChangeSince(soft) > Seen);
}

TEST_CASE("Rigs replace the lights, and a reset brings back those of the scene", "[lights]")
{
  LightSession session;
  const auto before = session.TakePicture();
  session.Find<QAction>("rig1")->trigger();
  CHECK(session.CountLights() == 3);
  CHECK(session.ChangeSince(before) > Seen);
  session.Window.GetLightPanel()->GetResetAction()->trigger();
  CHECK(session.CountLights() == 1);
  CHECK(session.ChangeSince(before) == 0.0);
}
