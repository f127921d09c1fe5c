#include "Catch.h"
#include "ImageComparison.h"
#include "ViewerSession.h"

#include <QAbstractButton>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QTabWidget>
#include <QTableView>

#include <vtkImageData.h>

using namespace penumbra;

namespace
{
// What an edit that is seen changes at least.
constexpr double Seen = 2.0;

struct TableSession : ViewerSession
{
  TableSession()
  {
    REQUIRE(this->Open(this->Files.File));
    auto* const pages = this->Find<QTabWidget>("transferFunctionPages");
    pages->setCurrentIndex(1);
  }

  const TransferFunctionDescription& Function()
  {
    return this->Document.GetScene().TransferFunction;
  }

  // By the keyboard alone: F2, the text, Enter.
  void Type(const char* name, int row, int column, const QString& text)
  {
    auto* const table = this->Find<QTableView>(name);
    table->setCurrentIndex(table->model()->index(row, column));
    this->Press(table, Qt::Key_F2);
    auto* const line = table->viewport()->findChild<QLineEdit*>();
    REQUIRE(line);
    TypeText(line, text);
    this->Press(line, Qt::Key_Return);
    QApplication::processEvents();
    QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); // the editor
  }

  void Press(QWidget* widget, int key)
  {
    QKeyEvent event(QEvent::KeyPress, key, Qt::NoModifier);
    QApplication::sendEvent(widget, &event);
  }

  QString TextAt(const char* name, int row, int column)
  {
    return this->Find<QTableView>(name)->model()->index(row, column).data().toString();
  }
};
}

TEST_CASE("Points of opacity are edited by the keyboard, in every language", "[points]")
{
  TableSession session;
  const auto before = session.TakePicture();
  CHECK(session.TextAt("Points of opacity", 1, 0) == "200");
  for (const char* text : { "0,05", "0.05" })
  {
    session.Type("Points of opacity", 1, 1, text);
    CHECK((*session.Function().Opacity)[1][1] == 0.05);
    CHECK(session.TextAt("Points of opacity", 1, 1) == "0.05");
    CHECK(session.ChangeSince(before) > Seen);
    session.Document.GetHistory()->undo();
    CHECK(session.TextAt("Points of opacity", 1, 1) == "0.5");
  }
  CHECK(session.ChangeSince(before) == 0.0);
}

TEST_CASE("A point that is moved past another one stays the current one", "[points]")
{
  TableSession session;
  session.Type("Points of opacity", 0, 0, "220");
  CHECK((*session.Function().Opacity)[0][0] == 200.0);
  CHECK((*session.Function().Opacity)[1] == std::array<double, 2>{ 220.0, 0.0 });
  CHECK(session.Find<QTableView>("Points of opacity")->currentIndex().row() == 1);
}

TEST_CASE("A point that is added changes nothing until it is moved, and is removed", "[points]")
{
  TableSession session;
  const auto before = session.TakePicture();
  for (const char* name : { "Points of opacity", "Points of colour" })
  {
    CAPTURE(name);
    auto* const table = session.Find<QTableView>(name);
    table->setCurrentIndex(table->model()->index(0, 1));
    session.Find<QAbstractButton>(QString(name) + " add")->click();
    CHECK(table->model()->rowCount() == 3);
    CHECK(table->currentIndex().row() == 1);
    CHECK(session.ChangeSince(before) < 0.1); // tables of colours and opacities are of finite size
    auto* const remove = session.Find<QAbstractButton>(QString(name) + " remove");
    remove->click();
    CHECK(session.ChangeSince(before) == 0.0);
    remove->click();
    CHECK(table->model()->rowCount() == 1);
    CHECK_FALSE(remove->isEnabled()); // a function has at least one point
    session.Document.GetHistory()->undo();
  }
}

TEST_CASE("Colours are read and typed as #rrggbb", "[points]")
{
  TableSession session;
  const auto before = session.TakePicture();
  CHECK(session.TextAt("Points of colour", 0, 1) == "#e6804d");
  session.Type("Points of colour", 1, 1, "#0000ff");
  CHECK((*session.Function().Color)[1] == std::array<double, 4>{ 255.0, 0.0, 0.0, 1.0 });
  CHECK(session.ChangeSince(before) > Seen);
  const int edits = session.Document.GetHistory()->index();
  session.Type("Points of colour", 1, 1, "no colour");
  session.Type("Points of colour", 0, 1, "#e6804d"); // as it is shown: no change of its floats
  CHECK(session.Document.GetHistory()->index() == edits);
}
