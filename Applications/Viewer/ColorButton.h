/**
 * @class   ColorButton
 * @brief   shows a colour and lets one choose another
 */

#ifndef ColorButton_h
#define ColorButton_h

#include "Vector3.h"

#include <QColor>
#include <QToolButton>

namespace penumbra
{

QColor ToQColor(const Vector3& color);
Vector3 FromQColor(const QColor& color);

class ColorButton : public QToolButton
{
  Q_OBJECT
public:
  explicit ColorButton(QWidget* parent = nullptr);

  void ShowColor(const Vector3& color);

signals:
  /// By the user.
  void edited(const penumbra::Vector3& color);

private:
  void Choose();

  Vector3 Color = { 1.0, 1.0, 1.0 };
};

}

#endif
