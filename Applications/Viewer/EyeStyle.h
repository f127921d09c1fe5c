/**
 * @class   EyeStyle
 * @brief   shows the check marks of lists and trees as eyes: open for what is shown, else closed
 *
 * They are clicked, and toggled by the space key, as check marks are.
 */

#ifndef EyeStyle_h
#define EyeStyle_h

#include <QProxyStyle>

namespace penumbra
{

class EyeStyle : public QProxyStyle
{
  Q_OBJECT
public:
  explicit EyeStyle(QObject* parent);

  int pixelMetric(
    PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override;
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
    const QWidget* widget) const override;
};

}

#endif
