/**
 * @class   NumberSlider
 * @brief   a slider and a number box for one number
 */

#ifndef NumberSlider_h
#define NumberSlider_h

#include "NumberBox.h"

#include <QWidget>

class QSlider;

namespace penumbra
{

class NumberSlider : public QWidget
{
  Q_OBJECT
public:
  /// The slider covers the range up to `slideTo`; the box takes all of it.
  NumberSlider(const NumberRange& range, double slideTo, QWidget* parent = nullptr);

  void ShowValue(double value);
  void SetNames(const QString& name, const QString& tip);

signals:
  /// By the user.
  void edited(double value);

private:
  double Lowest;
  double SlideTo;
  QSlider* Slider;
  NumberBox* Box;
};

}

#endif
