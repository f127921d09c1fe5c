#include "MessageBar.h"

#include <QAccessible>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace penumbra
{

//------------------------------------------------------------------------------
MessageBar::MessageBar(QWidget* parent)
  : QFrame(parent)
  , Label(new QLabel(this))
{
  this->setObjectName("messageBar");
  auto* const layout = new QHBoxLayout(this);
  layout->setContentsMargins(10, 6, 6, 6);
  this->Label->setWordWrap(true);
  this->Label->setTextFormat(Qt::PlainText);
  this->Label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  layout->addWidget(this->Label, 1);
  auto* const close = new QToolButton(this);
  close->setText(QString::fromUtf8("\u2715"));
  close->setAutoRaise(true);
  close->setAccessibleName(tr("Close message"));
  close->setToolTip(tr("Close this message"));
  layout->addWidget(close, 0, Qt::AlignTop);
  this->connect(close, &QToolButton::clicked, this, &QWidget::hide);
  parent->installEventFilter(this);
  this->hide();
}

//------------------------------------------------------------------------------
bool MessageBar::eventFilter(QObject* watched, QEvent* event)
{
  if (event->type() == QEvent::Resize)
  {
    this->Place();
  }
  return QFrame::eventFilter(watched, event);
}

//------------------------------------------------------------------------------
void MessageBar::Place()
{
  const int width = this->parentWidget()->width();
  this->setGeometry(0, 0, width, this->layout()->totalHeightForWidth(width));
}

//------------------------------------------------------------------------------
void MessageBar::ShowError(const QString& text)
{
  this->ShowText(text, QColor(0xa8, 0x32, 0x32));
}

//------------------------------------------------------------------------------
void MessageBar::ShowNotice(const QString& text)
{
  this->ShowText(text, QColor(0x2f, 0x62, 0x96));
}

//------------------------------------------------------------------------------
QString MessageBar::GetText() const
{
  return this->isHidden() ? QString() : this->Label->text();
}

//------------------------------------------------------------------------------
void MessageBar::ShowText(const QString& text, const QColor& color)
{
  this->Label->setText(text);
  this->setStyleSheet(
    QString("#messageBar { background: %1; } #messageBar QLabel, QToolButton { color: white; }")
      .arg(color.name()));
  this->setAccessibleName(text);
  this->Place();
  this->show();
  this->raise();
  QAccessibleEvent event(this, QAccessible::Alert);
  QAccessible::updateAccessibility(&event);
}

}
