#include "Catch.h"
#include "ImageComparison.h"
#include "ViewerSession.h"

#include <QAccessible>
#include <QApplication>
#include <QTest>
#include <QTreeWidget>

#include <vtkImageData.h>

#include <algorithm>

using namespace penumbra;

namespace
{
struct TreeSession : ViewerSession
{
  TreeSession() { REQUIRE(this->Open(this->Files.File)); }

  QTreeWidgetItem* Volume() { return this->Tree->topLevelItem(0)->child(0); }
  QTreeWidgetItem* Light() { return this->Volume()->child(0); }

  // The eye stands before the name.
  QPoint EyeOf(QTreeWidgetItem* item)
  {
    return this->Tree->visualItemRect(item).topLeft() + QPoint(9, 9);
  }
  QPoint Eye() { return this->EyeOf(this->Light()); }

  bool IsOn() { return this->Document.GetScene().Lights[0].On; }

  QImage DrawnEye()
  {
    return this->Tree->viewport()->grab({ this->Eye() - QPoint(9, 9), QSize(18, 18) }).toImage();
  }

  QTreeWidget* Tree = this->Find<QTreeWidget>("pipelineTree");
};

bool IsOneColor(vtkImageData* picture)
{
  const auto* const bytes = static_cast<const unsigned char*>(picture->GetScalarPointer());
  const vtkIdType pixel = picture->GetNumberOfScalarComponents();
  return std::equal(bytes + pixel, bytes + pixel * picture->GetNumberOfPoints(), bytes);
}

QStringList NamesForScreenReaders(QWidget* widget)
{
  QAccessibleInterface* whole = QAccessible::queryAccessibleInterface(widget);
  QStringList names;
  for (int i = 0; i < whole->childCount(); ++i)
  {
    names << whole->child(i)->text(QAccessible::Name);
  }
  return names;
}
}

TEST_CASE("The eye of a light opens and closes by the mouse")
{
  TreeSession session;
  const auto lit = session.TakePicture();
  const QImage open = session.DrawnEye();
  QTest::mouseClick(session.Tree->viewport(), Qt::LeftButton, Qt::NoModifier, session.Eye());
  CHECK(WaitFor([&] { return !session.IsOn(); }, 5.0));
  CHECK(session.ChangeSince(lit) > 2.0);
  CHECK(session.DrawnEye() != open);
  QTest::mouseClick(session.Tree->viewport(), Qt::LeftButton, Qt::NoModifier, session.Eye());
  CHECK(WaitFor([&] { return session.IsOn(); }, 5.0));
  CHECK(session.ChangeSince(lit) == 0.0);
}

TEST_CASE("The eye of a light opens and closes by the space key, as often as one likes")
{
  TreeSession session;
  session.Tree->setCurrentItem(session.Light());
  for (const bool on : { false, true, false })
  {
    QTest::keyClick(session.Tree, Qt::Key_Space);
    CHECK(WaitFor([&] { return session.IsOn() == on; }, 5.0));
    CHECK(session.Tree->currentItem() == session.Light());
  }
}

TEST_CASE("Screen readers are told whether a light is shown")
{
  TreeSession session;
  CHECK(NamesForScreenReaders(session.Tree).contains("key, shown"));
  session.Document.Edit("off", [](SceneDescription& scene) { scene.Lights[0].On = false; });
  CHECK(NamesForScreenReaders(session.Tree).contains("key, hidden"));
}

TEST_CASE("The eye of the volume hides it in the view alone, until a file is opened")
{
  TreeSession session;
  const auto shown = session.TakePicture();
  const auto isSeen = [&] { return session.ChangeSince(shown) == 0.0; };
  const auto closeEye = [&]
  {
    session.Tree->setCurrentItem(session.Volume());
    QTest::keyClick(session.Tree, Qt::Key_Space);
    return WaitFor(
      [&] { return NamesForScreenReaders(session.Tree).contains("Volume, hidden"); }, 5.0);
  };
  CHECK(closeEye());
  CHECK_FALSE(IsOneColor(shown));
  CHECK(IsOneColor(session.TakePicture()));
  CHECK_FALSE(session.Window.isWindowModified());
  session.Document.Edit("off", [](SceneDescription& scene) { scene.Lights[0].On = false; });
  session.Document.GetHistory()->undo();
  CHECK_FALSE(isSeen());
  QTest::mouseClick(
    session.Tree->viewport(), Qt::LeftButton, Qt::NoModifier, session.EyeOf(session.Volume()));
  CHECK(WaitFor(isSeen, 5.0));
  CHECK(closeEye());
  REQUIRE(session.Open(session.Files.File));
  CHECK(isSeen());
}
