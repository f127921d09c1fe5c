/**
 * @class   NumberBox
 * @brief   a spin box for numbers that is the same in every language
 *
 * A point is shown; a comma that is typed counts as a point. There are no thousands separators.
 */

#ifndef NumberBox_h
#define NumberBox_h

#include <QDoubleSpinBox>

namespace penumbra
{

struct NumberRange
{
  double Lowest = 0.0;
  double Highest = 1.0;
  int Decimals = 2;
  QString Unit = {}; ///< after the number
};

class NumberBox : public QDoubleSpinBox
{
  Q_OBJECT
public:
  explicit NumberBox(const NumberRange& range, QWidget* parent = nullptr);

  /// Shows a number without valueChanged().
  void ShowValue(double value);

protected:
  QValidator::State validate(QString& text, int& position) const override;
  double valueFromText(const QString& text) const override;
  QString textFromValue(double value) const override;
  void wheelEvent(QWheelEvent* event) override;
};

}

#endif
