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
  for (NumberBox*& box : this->Boxes)
  {
    box = new NumberBox(range, this);
    box->setButtonSymbols(QAbstractSpinBox::NoButtons);
    box->setMinimumWidth(48);
    layout->addWidget(box, 1);
    this->connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
      [this]
      {
        emit this->edited(
          { this->Boxes[0]->value(), this->Boxes[1]->value(), this->Boxes[2]->value() });
      });
  }
}

//------------------------------------------------------------------------------
void VectorEdit::ShowVector(const Vector3& vector)
{
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
