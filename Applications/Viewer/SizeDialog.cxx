#include "SizeDialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QSpinBox>
#include <QVBoxLayout>

namespace penumbra
{
namespace
{
// What OpenGL draws at once at least on most machines.
constexpr int LargestSide = 8192;
}

//------------------------------------------------------------------------------
SizeDialog::SizeDialog(const QString& title, const std::array<int, 2>& size, QWidget* parent)
  : QDialog(parent)
  , Form(new QFormLayout)
{
  this->setWindowTitle(title);
  auto* const column = new QVBoxLayout(this);
  column->addLayout(this->Form);
  this->Width = this->AddBox(tr("Width in pixels"), size[0], 1, LargestSide);
  this->Height = this->AddBox(tr("Height in pixels"), size[1], 1, LargestSide);
  auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  column->addWidget(buttons);
  this->connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  this->connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

//------------------------------------------------------------------------------
QSpinBox* SizeDialog::AddBox(const QString& label, int value, int lowest, int highest)
{
  auto* const box = new QSpinBox(this);
  box->setRange(lowest, highest);
  box->setValue(value);
  box->setAccessibleName(label);
  this->Form->addRow(label, box);
  return box;
}

//------------------------------------------------------------------------------
void SizeDialog::AddNumber(const QString& label, int value, int lowest, int highest)
{
  this->Number = this->AddBox(label, value, lowest, highest);
}

//------------------------------------------------------------------------------
std::array<int, 2> SizeDialog::GetSize() const
{
  return { this->Width->value(), this->Height->value() };
}

//------------------------------------------------------------------------------
int SizeDialog::GetNumber() const
{
  return this->Number->value();
}

}
