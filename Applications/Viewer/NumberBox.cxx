#include "NumberBox.h"

#include <QSignalBlocker>
#include <QWheelEvent>

#include <cmath>

namespace penumbra
{

//------------------------------------------------------------------------------
NumberBox::NumberBox(const NumberRange& range, QWidget* parent)
  : QDoubleSpinBox(parent)
{
  this->setLocale(QLocale::c());
  this->setDecimals(range.Decimals);
  this->setRange(range.Lowest, range.Highest);
  this->setSuffix(range.Unit);
  this->setSingleStep(std::pow(10.0, -std::min(range.Decimals, 2)) * 5.0);
  this->setKeyboardTracking(false);
  this->setFocusPolicy(Qt::StrongFocus);
}

//------------------------------------------------------------------------------
void NumberBox::ShowValue(double value)
{
  const QSignalBlocker blocker(this);
  this->setValue(value);
}

//------------------------------------------------------------------------------
QValidator::State NumberBox::validate(QString& text, int& position) const
{
  text.replace(',', '.');
  return QDoubleSpinBox::validate(text, position);
}

//------------------------------------------------------------------------------
double NumberBox::valueFromText(const QString& text) const
{
  return QDoubleSpinBox::valueFromText(QString(text).replace(',', '.'));
}

//------------------------------------------------------------------------------
QString NumberBox::textFromValue(double value) const
{
  QString text = QLocale::c().toString(value, 'f', this->decimals());
  while (text.contains('.') && (text.endsWith('0') || text.endsWith('.')))
  {
    const bool point = text.endsWith('.');
    text.chop(1);
    if (point)
    {
      break;
    }
  }
  return text;
}

//------------------------------------------------------------------------------
void NumberBox::wheelEvent(QWheelEvent* event)
{
  // Scrolling a panel is not to change what happens to pass under the pointer.
  if (this->hasFocus())
  {
    QDoubleSpinBox::wheelEvent(event);
  }
  else
  {
    event->ignore();
  }
}

}
