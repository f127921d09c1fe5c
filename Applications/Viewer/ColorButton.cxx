#include "ColorButton.h"

#include <QColorDialog>
#include <QPainter>
#include <QPixmap>

#include <algorithm>

namespace penumbra
{

//------------------------------------------------------------------------------
QColor ToQColor(const Vector3& color)
{
  return QColor::fromRgbF(
    std::clamp(color[0], 0.0, 1.0), std::clamp(color[1], 0.0, 1.0), std::clamp(color[2], 0.0, 1.0));
}

//------------------------------------------------------------------------------
Vector3 FromQColor(const QColor& color)
{
  // What the user chose has 8 bits.
  return { color.red() / 255.0, color.green() / 255.0, color.blue() / 255.0 };
}

//------------------------------------------------------------------------------
ColorButton::ColorButton(QWidget* parent)
  : QToolButton(parent)
{
  this->setIconSize({ 48, 16 });
  this->setFocusPolicy(Qt::StrongFocus);
  this->connect(this, &QToolButton::clicked, this, &ColorButton::Choose);
  this->ShowColor(this->Color);
}

//------------------------------------------------------------------------------
void ColorButton::ShowColor(const Vector3& color)
{
  this->Color = color;
  QPixmap swatch(this->iconSize());
  swatch.fill(ToQColor(color));
  QPainter painter(&swatch);
  painter.setPen(QColor(128, 128, 128));
  painter.drawRect(swatch.rect().adjusted(0, 0, -1, -1));
  this->setIcon(swatch);
  this->setAccessibleDescription(ToQColor(color).name());
}

//------------------------------------------------------------------------------
void ColorButton::Choose()
{
  QColorDialog dialog(ToQColor(this->Color), this);
  dialog.setWindowTitle(this->accessibleName());
  this->connect(&dialog, &QColorDialog::currentColorChanged, this,
    [this](const QColor& color) { emit this->edited(FromQColor(color)); });
  const Vector3 before = this->Color;
  if (dialog.exec() == QDialog::Rejected)
  {
    emit this->edited(before);
  }
}

}
