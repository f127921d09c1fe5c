#include "Catch.h"
#include "ViewerSession.h"

#include <QDockWidget>
#include <QTest>
#include <QTreeWidget>

using namespace penumbra;

namespace
{
constexpr int Narrow = 900;
constexpr int Wide = 1280;

struct SizedSession : ViewerSession
{
  explicit SizedSession(int width)
  {
    this->Resize(width);
    REQUIRE(this->Open(this->Files.File));
  }

  void Resize(int width)
  {
    this->Window.resize(width, 640);
    REQUIRE(WaitFor([=] { return this->Window.width() == width; }, 5.0));
  }

  QDockWidget* Dock(const QString& name) { return this->Find<QDockWidget>(name); }

  bool IsLeft(const QString& dock)
  {
    return this->Window.dockWidgetArea(this->Dock(dock)) == Qt::LeftDockWidgetArea;
  }

  bool IsCovered(const QString& dock) { return this->Dock(dock)->visibleRegion().isEmpty(); }
};
}

TEST_CASE("In a narrow window the panels share a column, and the view has more than half of it")
{
  SizedSession session(Narrow);
  CHECK(session.Window.tabifiedDockWidgets(session.Dock("lightDock")).size() == 4);
  CHECK(session.Window.GetView()->width() > Narrow / 2);
  CHECK_FALSE(session.IsCovered("lightDock"));
}

TEST_CASE("A window that becomes wide again has its panels where they were")
{
  SizedSession session(Wide);
  session.Window.addDockWidget(Qt::BottomDockWidgetArea, session.Dock("informationDock"));
  session.Resize(Narrow);
  CHECK_FALSE(session.IsLeft("pipelineDock"));
  session.Window.RememberLayout();
  session.Resize(Wide);
  CHECK(session.IsLeft("pipelineDock"));
  CHECK(session.Window.dockWidgetArea(session.Dock("informationDock")) == Qt::BottomDockWidgetArea);

  SizedSession next(Wide);
  next.Window.RestoreLayout();
  CHECK(WaitFor([&] { return !next.IsLeft("pipelineDock"); }, 5.0)); // as narrow as it was closed
  next.Resize(Wide);
  CHECK(next.IsLeft("pipelineDock"));
}

TEST_CASE("In a shared column the pipeline is not covered before controls are asked for")
{
  SizedSession session(Narrow);
  auto* const tree = session.Find<QTreeWidget>("pipelineTree");
  session.Dock("pipelineDock")->raise();
  REQUIRE(WaitFor([&] { return !session.IsCovered("pipelineDock"); }, 5.0));
  tree->setCurrentItem(tree->topLevelItem(0)->child(0));
  CHECK_FALSE(session.IsCovered("pipelineDock"));
  QTest::keyClick(tree, Qt::Key_Return);
  CHECK(WaitFor([&] { return !session.IsCovered("appearanceDock"); }, 5.0));
}
