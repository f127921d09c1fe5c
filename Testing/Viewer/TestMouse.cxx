#include "Catch.h"
#include "ImageComparison.h"
#include "ViewerSession.h"

#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QScrollArea>
#include <QStyleOptionSpinBox>
#include <QTabBar>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <QWheelEvent>

#include <vtkImageData.h>

using namespace penumbra;

namespace
{
// What is seen changes by at least so many grey levels of 255.
constexpr double Seen = 2.0;

// More than any page has.
constexpr int MostNotches = 50;

// A person without a keyboard, who clicks on what is seen of a widget and nowhere else.
struct MouseSession : ViewerSession
{
  MouseSession() { REQUIRE(this->Open(this->Files.File)); }

  static void Click(QWidget* widget, const QPoint& place)
  {
    REQUIRE(widget->isVisible());
    REQUIRE(widget->isEnabled());
    REQUIRE(widget->visibleRegion().contains(place));
    QTest::mouseClick(widget, Qt::LeftButton, Qt::NoModifier, place);
  }

  static void Click(QWidget* widget)
  {
    TurnWheelUntilSeen(widget);
    Click(widget, widget->rect().center());
  }

  // Down the page that it stands on.
  static void TurnWheelUntilSeen(QWidget* widget)
  {
    QWidget* page = widget;
    while (page && !qobject_cast<QScrollArea*>(page))
    {
      page = page->parentWidget();
    }
    const auto isSeen = [=] { return widget->visibleRegion().contains(widget->rect().center()); };
    for (int notch = 0; page && notch < MostNotches && !isSeen(); ++notch)
    {
      QWidget* const paper = qobject_cast<QScrollArea*>(page)->viewport();
      const QPointF place(1.0, 1.0);
      QWheelEvent wheel(place, paper->mapToGlobal(place.toPoint()), {}, { 0, -120 }, Qt::NoButton,
        Qt::NoModifier, Qt::NoScrollPhase, false);
      QApplication::sendEvent(paper, &wheel);
    }
  }

  // Pages share names of controls.
  template <typename Type>
  Type* FindSeen(const QString& name)
  {
    for (Type* found : this->Window.findChildren<Type*>(name))
    {
      if (found->isVisible())
      {
        return found;
      }
    }
    FAIL("No " << name.toStdString() << " is seen.");
    return nullptr;
  }

  // A menu's own loop takes the events until an entry is clicked.
  void ChooseInMenu(QToolButton* button, QAction* entry)
  {
    QTimer::singleShot(0,
      [=]
      {
        auto* const menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        REQUIRE(menu);
        Click(menu, menu->actionGeometry(entry).center());
      });
    Click(button);
  }

  void ChooseInBox(QComboBox* box, int row)
  {
    Click(box);
    REQUIRE(WaitFor([=] { return box->view()->isVisible(); }, 5.0));
    QTest::qWait(2 * QApplication::doubleClickInterval()); // else it belongs to the click before
    Click(box->view()->viewport(),
      box->view()->visualRect(box->model()->index(row, box->modelColumn())).center());
  }

  // One of the basic colours of the dialog.
  void ChooseColor(const QString& control)
  {
    QTimer::singleShot(0,
      []
      {
        auto* const dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        REQUIRE(dialog);
        QWidget* const colors = dialog->findChildren<QWidget*>("", Qt::FindDirectChildrenOnly)[0];
        Click(colors, QPoint(40, 8));
        Click(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok));
      });
    Click(this->FindSeen<QWidget>(control));
  }

  void StepDown(QDoubleSpinBox* box)
  {
    QStyleOptionSpinBox option;
    option.initFrom(box);
    option.subControls = QStyle::SC_All;
    option.buttonSymbols = box->buttonSymbols();
    option.frame = box->hasFrame();
    Click(box,
      box->style()
        ->subControlRect(QStyle::CC_SpinBox, &option, QStyle::SC_SpinBoxDown, box)
        .center());
  }

  void ChooseInMenuBar(QAction* entry)
  {
    auto* const menu = qobject_cast<QMenu*>(entry->associatedWidgets()[0]);
    REQUIRE(menu);
    QMenuBar* const bar = this->Window.menuBar();
    Click(bar, bar->actionGeometry(menu->menuAction()).center());
    REQUIRE(WaitFor([=] { return menu->isVisible(); }, 5.0));
    Click(menu, menu->actionGeometry(entry).center());
  }

  QPoint EyeOf(int row)
  {
    auto* const list = this->Find<QListWidget>("lightList");
    return list->visualItemRect(list->item(row)).topLeft() + QPoint(9, 9);
  }

  const std::vector<LightDescription>& Lights() { return this->Document.GetScene().Lights; }
};
}

TEST_CASE("Lights are added, modified and removed by the mouse alone", "[lights]")
{
  MouseSession session;
  const auto one = session.TakePicture();
  session.ChooseInMenu(
    session.Find<QToolButton>("addLightButton"), session.Find<QAction>("addLight0"));
  REQUIRE(session.Lights().size() == 2);
  CHECK(session.ChangeSince(one) > Seen);

  const auto two = session.TakePicture();
  auto* const ball = session.Find<QWidget>("directionBall");
  const QPoint middle = ball->rect().center();
  QTest::mousePress(ball, Qt::LeftButton, Qt::NoModifier, middle);
  QTest::mouseMove(ball, middle + QPoint(25, 10));
  QTest::mouseRelease(ball, Qt::LeftButton, Qt::NoModifier, middle + QPoint(25, 10));
  CHECK(session.ChangeSince(two) > Seen);

  const double brightness = session.Lights()[1].Intensity;
  session.StepDown(session.FindSeen<QDoubleSpinBox>("Brightness"));
  CHECK(session.Lights()[1].Intensity < brightness);
  session.ChooseInBox(session.FindSeen<QComboBox>("Shadow"), 0);
  CHECK(session.Lights()[1].Shadow == ShadowKind::None);
  session.ChooseInBox(session.FindSeen<QComboBox>("Shadow"), 2);
  CHECK(session.Lights()[1].Shadow == ShadowKind::Hard);

  const auto bright = session.TakePicture();
  auto* const list = session.Find<QListWidget>("lightList")->viewport();
  session.Click(list, session.EyeOf(1));
  CHECK_FALSE(session.Lights()[1].On);
  CHECK(session.ChangeSince(bright) > Seen);
  session.Click(list, session.EyeOf(1));
  CHECK(session.ChangeSince(bright) == 0.0);

  session.Click(session.Find<QWidget>("removeLightButton"));
  CHECK(session.Lights().size() == 1);
  CHECK(session.ChangeSince(one) == 0.0);
  session.Click(session.Find<QWidget>("removeLightButton"));
  CHECK(session.Lights().empty());
  CHECK_FALSE(session.Find<QWidget>("removeLightButton")->isEnabled());
}

TEST_CASE("Colours and place of a light are modified by the mouse alone", "[lights]")
{
  MouseSession session;
  session.ChooseInMenu(
    session.Find<QToolButton>("addLightButton"), session.Find<QAction>("addLight1"));
  auto* const tabs = session.Find<QWidget>("lightPanel")->findChild<QTabBar*>();
  session.Click(tabs, tabs->tabRect(1).center());
  const auto light = [&]() -> const LightDescription& { return session.Lights()[1]; };
  for (const char* control : { "Diffuse colour", "Specular colour", "Ambient colour" })
  {
    CAPTURE(control);
    const auto before = session.TakePicture();
    session.ChooseColor(control);
    CHECK(session.ChangeSince(before) > 0.0);
  }
  CHECK(light().Diffuse != Vector3{ 1.0, 1.0, 1.0 });
  CHECK(light().Specular == light().Diffuse);
  CHECK(light().Ambient == light().Diffuse);

  const auto before = session.TakePicture();
  session.ChooseInMenuBar(session.Find<QAction>("showLight"));
  const Vector3 place = light().Position;
  session.DragInView(place, Sum(place, { 14.0, 14.0, 0.0 }));
  CHECK(Length(Difference(light().Position, place)) > 5.0);
  CHECK(session.ChangeSince(before) > Seen);
}
