#include "NumberSlider.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>

#include <algorithm>

namespace penumbra
{
namespace
{
constexpr int Positions = 1000;
}

//------------------------------------------------------------------------------
NumberSlider::NumberSlider(const NumberRange& range, double slideTo, QWidget* parent)
  : QWidget(parent)
  , Lowest(range.Lowest)
  , SlideTo(slideTo)
  , Slider(new QSlider(Qt::Horizontal, this))
  , Box(new NumberBox(range, this))
{
  auto* const layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(this->Slider, 1);
  layout->addWidget(this->Box);
  this->Box->setFixedWidth(76);
  this->Slider->setRange(0, Positions);
  this->Slider->setPageStep(Positions / 10);
  this->Slider->setSingleStep(Positions / 100);
  this->connect(this->Slider, &QSlider::valueChanged, this,
    [this](int position)
    {
      const double value =
        this->Lowest + (this->SlideTo - this->Lowest) * position / double(Positions);
      this->Box->ShowValue(value);
      emit this->edited(this->Box->value());
    });
  this->connect(this->Box, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
    [this](double value)
    {
      this->ShowValue(value);
      emit this->edited(value);
    });
}

//------------------------------------------------------------------------------
void NumberSlider::ShowValue(double value)
{
  this->Box->ShowValue(value);
  const QSignalBlocker blocker(this->Slider);
  const double part = (value - this->Lowest) / (this->SlideTo - this->Lowest);
  this->Slider->setValue(static_cast<int>(std::clamp(part, 0.0, 1.0) * Positions + 0.5));
}

//------------------------------------------------------------------------------
void NumberSlider::SetNames(const QString& name, const QString& tip)
{
  this->setToolTip(tip);
  this->Slider->setAccessibleName(name);
  this->Slider->setAccessibleDescription(tip);
  this->Box->setAccessibleName(name);
  this->Box->setAccessibleDescription(tip);
  this->Slider->setObjectName(name + " slider");
  this->Box->setObjectName(name);
}

}
