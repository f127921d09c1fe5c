#include "DirectionBall.h"

#include "ColorButton.h"

#include <QImage>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
// Of the ball's radius: how far the ring reaches, at whose outer edge the light is right behind.
constexpr double RingRadius = 1.4;
constexpr double Pi = 3.14159265358979323846;
constexpr double KeyStep = Pi / 36.0;
constexpr double HandleRadius = 6.0;
}

//------------------------------------------------------------------------------
DirectionBall::DirectionBall(QWidget* parent)
  : QWidget(parent)
{
  this->setObjectName("directionBall");
  this->setAccessibleName(tr("Direction of the light"));
  this->setFocusPolicy(Qt::StrongFocus);
  this->setMinimumSize(120, 120);
  this->setCursor(Qt::PointingHandCursor);
  this->setToolTip(
    tr("Drag the light around the ball: the picture is lit from there. In the ring "
       "around the ball the light comes from behind. Arrow keys turn it by 5 degrees."));
}

//------------------------------------------------------------------------------
void DirectionBall::ShowDirection(const Vector3& toLight, const Vector3& color)
{
  this->ToLight = toLight;
  this->Color = color;
  const double degrees = std::acos(std::clamp(toLight[2], -1.0, 1.0)) * 180.0 / Pi;
  this->setAccessibleDescription(
    tr("%1, %2, %3 degrees off your view")
      .arg(toLight[0] < 0.0 ? tr("from the left") : tr("from the right"))
      .arg(toLight[1] < 0.0 ? tr("from below") : tr("from above"))
      .arg(qRound(degrees)));
  this->update();
}

//------------------------------------------------------------------------------
double DirectionBall::Radius() const
{
  return (0.5 * std::min(this->width(), this->height()) - HandleRadius - 1.0) / RingRadius;
}

//------------------------------------------------------------------------------
QPointF DirectionBall::Middle() const
{
  return { 0.5 * this->width(), 0.5 * this->height() };
}

//------------------------------------------------------------------------------
QPointF DirectionBall::PlaceOf(const Vector3& toLight) const
{
  const double across = std::hypot(toLight[0], toLight[1]);
  double distance = across;
  if (toLight[2] < 0.0)
  {
    distance = 1.0 + (RingRadius - 1.0) * std::acos(std::min(across, 1.0)) / (Pi / 2.0);
  }
  const double scale = across > 1e-9 ? distance * this->Radius() / across : 0.0;
  const QPointF offset = toLight[2] < 0.0 && across <= 1e-9
    ? QPointF(0.0, RingRadius * this->Radius())
    : QPointF(toLight[0] * scale, -toLight[1] * scale);
  return this->Middle() + offset;
}

//------------------------------------------------------------------------------
Vector3 DirectionBall::DirectionAt(const QPointF& place) const
{
  const QPointF offset = (place - this->Middle()) / this->Radius();
  const double distance = std::hypot(offset.x(), offset.y());
  if (distance <= 1.0)
  {
    return { offset.x(), -offset.y(), std::sqrt(1.0 - distance * distance) };
  }
  const double part = std::min((distance - 1.0) / (RingRadius - 1.0), 1.0);
  const double behind = part * Pi / 2.0;
  const double across = std::cos(behind) / distance;
  return { offset.x() * across, -offset.y() * across, -std::sin(behind) };
}

//------------------------------------------------------------------------------
QImage DirectionBall::MakePicture() const
{
  const double ratio = this->devicePixelRatioF();
  const int size = static_cast<int>(std::ceil(2.0 * this->Radius() * ratio));
  QImage image(size, size, QImage::Format_ARGB32_Premultiplied);
  for (int y = 0; y < size; ++y)
  {
    auto* const line = reinterpret_cast<QRgb*>(image.scanLine(y));
    for (int x = 0; x < size; ++x)
    {
      const double u = 2.0 * (x + 0.5) / size - 1.0;
      const double v = 1.0 - 2.0 * (y + 0.5) / size;
      const double squared = u * u + v * v;
      const double cover = std::clamp((1.0 - std::sqrt(squared)) * 0.5 * size, 0.0, 1.0);
      const Vector3 normal = { u, v, std::sqrt(std::max(0.0, 1.0 - squared)) };
      const double diffuse = std::max(0.0, Dot(normal, this->ToLight));
      const auto level = [&](double color)
      { return qRound(255.0 * cover * (0.1 + 0.9 * diffuse) * std::min(1.0, color)); };
      line[x] = qRgba(
        level(this->Color[0]), level(this->Color[1]), level(this->Color[2]), qRound(255 * cover));
    }
  }
  image.setDevicePixelRatio(ratio);
  return image;
}

//------------------------------------------------------------------------------
void DirectionBall::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setOpacity(this->isEnabled() ? 1.0 : 0.35);
  const double radius = this->Radius();
  painter.setPen(Qt::NoPen);
  QColor ring = this->palette().color(QPalette::WindowText);
  ring.setAlphaF(0.25);
  painter.setBrush(ring);
  painter.drawEllipse(this->Middle(), RingRadius * radius, RingRadius * radius);
  painter.drawImage(this->Middle() - QPointF(radius, radius), this->MakePicture());
  if (!this->isEnabled())
  {
    return;
  }
  const bool focused = this->hasFocus();
  painter.setPen(
    QPen(focused ? this->palette().color(QPalette::Highlight) : QColor(30, 30, 30), 2));
  painter.setBrush(ToQColor(this->Color));
  painter.drawEllipse(this->PlaceOf(this->ToLight), HandleRadius, HandleRadius);
}

//------------------------------------------------------------------------------
void DirectionBall::Turn(const Vector3& toLight)
{
  this->ShowDirection(toLight, this->Color);
  emit this->edited(toLight);
}

//------------------------------------------------------------------------------
void DirectionBall::mousePressEvent(QMouseEvent* event)
{
  this->mouseMoveEvent(event);
}

//------------------------------------------------------------------------------
void DirectionBall::mouseMoveEvent(QMouseEvent* event)
{
  if (event->buttons() & Qt::LeftButton)
  {
    this->Turn(this->DirectionAt(event->localPos()));
  }
}

//------------------------------------------------------------------------------
void DirectionBall::keyPressEvent(QKeyEvent* event)
{
  switch (event->key())
  {
    case Qt::Key_Left:
      return this->Turn(Rotated(this->ToLight, { 0.0, 1.0, 0.0 }, -KeyStep));
    case Qt::Key_Right:
      return this->Turn(Rotated(this->ToLight, { 0.0, 1.0, 0.0 }, KeyStep));
    case Qt::Key_Up:
      return this->Turn(Rotated(this->ToLight, { 1.0, 0.0, 0.0 }, -KeyStep));
    case Qt::Key_Down:
      return this->Turn(Rotated(this->ToLight, { 1.0, 0.0, 0.0 }, KeyStep));
    default:
      QWidget::keyPressEvent(event);
  }
}

}
