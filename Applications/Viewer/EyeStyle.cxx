#include "EyeStyle.h"

#include "Theme.h"

#include <QPainter>
#include <QPainterPath>
#include <QStyleOption>

namespace penumbra
{
namespace
{
constexpr int EyeSize = 18;

// In a square from -1 to 1.
constexpr double Corner = 0.85;
constexpr double LidHeight = 0.95; // of the control point: the lid is half as high
constexpr double PupilRadius = 0.27;
constexpr double LineWidth = 0.15;

QPainterPath MakeLid(double height)
{
  QPainterPath lid({ -Corner, 0.0 });
  lid.quadTo({ 0.0, height }, { Corner, 0.0 });
  return lid;
}

void DrawOpenEye(QPainter* painter)
{
  painter->drawPath(MakeLid(-LidHeight));
  painter->drawPath(MakeLid(LidHeight));
  painter->setBrush(painter->pen().color());
  painter->drawEllipse(QPointF(), PupilRadius, PupilRadius);
}

void DrawClosedEye(QPainter* painter)
{
  const QPainterPath lid = MakeLid(LidHeight);
  painter->drawPath(lid);
  for (const double along : { 0.15, 0.5, 0.85 })
  {
    const QPointF root = lid.pointAtPercent(along);
    painter->drawLine(root, root + QPointF(0.35 * root.x(), 0.3));
  }
}
}

//------------------------------------------------------------------------------
EyeStyle::EyeStyle(QObject* parent)
  : QProxyStyle(StyleName)
{
  this->setParent(parent);
}

//------------------------------------------------------------------------------
int EyeStyle::pixelMetric(
  PixelMetric metric, const QStyleOption* option, const QWidget* widget) const
{
  const bool isMark = metric == PM_IndicatorWidth || metric == PM_IndicatorHeight;
  return isMark ? EyeSize : QProxyStyle::pixelMetric(metric, option, widget);
}

//------------------------------------------------------------------------------
void EyeStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
  QPainter* painter, const QWidget* widget) const
{
  if (element != PE_IndicatorItemViewItemCheck)
  {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    return;
  }
  const bool open = option->state & State_On;
  const bool selected = option->state & State_Selected;
  const auto role = selected ? QPalette::HighlightedText : QPalette::Text;
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->translate(QRectF(option->rect).center());
  painter->scale(EyeSize / 2.0, EyeSize / 2.0);
  painter->setPen(QPen(option->palette.color(role), LineWidth, Qt::SolidLine, Qt::RoundCap));
  if (open)
  {
    DrawOpenEye(painter);
  }
  else
  {
    DrawClosedEye(painter);
  }
  painter->restore();
}

}
