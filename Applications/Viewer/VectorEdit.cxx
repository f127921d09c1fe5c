#include "VectorEdit.h"

#include <QHBoxLayout>

namespace penumbra
{

//------------------------------------------------------------------------------
VectorEdit::VectorEdit(const NumberRange& range, QWidget* parent)
  : QWidget(parent)
{
  auto* const layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(3);
  for (std::size_t i = 0; i < this->Boxes.size(); ++i)
  {
    auto* const box = new NumberBox(range, this);
    this->Boxes[i] = box;
    box->setButtonSymbols(QAbstractSpinBox::NoButtons);
    box->setMinimumWidth(48);
    layout->addWidget(box, 1);
    this->connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
      [this, i](double value)
      {
        this->Vector[i] = value; // the others as they are, not as they are shown
        emit this->edited(this->Vector);
      });
  }
}

//------------------------------------------------------------------------------
void VectorEdit::ShowVector(const Vector3& vector)
{
  this->Vector = vector;
  for (std::size_t i = 0; i < this->Boxes.size(); ++i)
  {
    this->Boxes[i]->ShowValue(vector[i]);
  }
}

//------------------------------------------------------------------------------
void VectorEdit::SetNames(const QString& name, const QString& tip)
{
  this->setToolTip(tip);
  const QString axes[] = { "x", "y", "z" };
  for (std::size_t i = 0; i < this->Boxes.size(); ++i)
  {
    this->Boxes[i]->setAccessibleName(name + " " + axes[i]);
    this->Boxes[i]->setAccessibleDescription(tip);
    this->Boxes[i]->setObjectName(name + " " + axes[i]);
  }
}

}
