#include "Catch.h"
#include "ViewerSession.h"

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QLineEdit>
#include <QScrollBar>

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
