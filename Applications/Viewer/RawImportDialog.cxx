#include "RawImportDialog.h"

#include "ScalarTypes.h"
#include "VectorEdit.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include <limits>

namespace penumbra
{
namespace
{
QString DescribeLayout(const RawLayout& layout)
{
  return QString::fromUtf8("%1\u2009\u00d7\u2009%2\u2009\u00d7\u2009%3, %4")
    .arg(layout.Dimensions[0])
    .arg(layout.Dimensions[1])
    .arg(layout.Dimensions[2])
    .arg(QString::fromStdString(layout.ScalarType));
}

QString Bytes(std::uint64_t count)
{
  const QString number = QLocale().toString(static_cast<qulonglong>(count));
  return count == 1 ? QObject::tr("1 byte") : QObject::tr("%1 bytes").arg(number);
}

void Name(QWidget* widget, const QString& name, const QString& tip)
{
  widget->setObjectName(name);
  widget->setAccessibleName(name);
  widget->setToolTip(tip);
}
}

//------------------------------------------------------------------------------
RawImportDialog::RawImportDialog(const QString& file, QWidget* parent)
  : QDialog(parent)
  , FileBytes(static_cast<std::uint64_t>(QFileInfo(file).size()))
{
  this->setWindowTitle(tr("Raw volume: %1").arg(QFileInfo(file).fileName()));
  auto* const column = new QVBoxLayout(this);
  auto* const hint = new QLabel(
    tr("A .raw file holds nothing but voxels. Say how its %1 are stored.").arg(Bytes(FileBytes)));
  hint->setWordWrap(true);
  column->addWidget(hint);
  auto* const form = new QFormLayout;
  column->addLayout(form);
  this->Proposals = ProposeLayouts(QFileInfo(file).fileName().toStdString(), this->FileBytes);
  this->AddProposals(form);
  this->AddControls(form);
  this->Verdict = new QLabel(this);
  this->Verdict->setWordWrap(true);
  this->Verdict->setObjectName("rawVerdict");
  column->addWidget(this->Verdict);
  this->Buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel, this);
  column->addWidget(this->Buttons);
  this->connect(this->Buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  this->connect(this->Buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  if (!this->Proposals.empty())
  {
    this->Layout = this->Proposals.front();
  }
  this->ShowLayout();
}

//------------------------------------------------------------------------------
void RawImportDialog::AddProposals(QFormLayout* form)
{
  auto* const box = new QComboBox(this);
  Name(box, tr("Likely"), tr("Sizes and types that fill the file exactly, the likeliest first"));
  for (const RawLayout& layout : this->Proposals)
  {
    box->addItem(DescribeLayout(layout));
  }
  if (this->Proposals.empty())
  {
    box->addItem(tr("none fills the file"));
  }
  box->setEnabled(!this->Proposals.empty());
  form->addRow(tr("Likely"), box);
  this->connect(box, qOverload<int>(&QComboBox::activated), this,
    [this](int proposal)
    {
      this->Layout = this->Proposals[static_cast<std::size_t>(proposal)];
      this->ShowLayout();
    });
}

//------------------------------------------------------------------------------
void RawImportDialog::AddControls(QFormLayout* form)
{
  auto* const row = new QHBoxLayout;
  const QString axes[] = { "x", "y", "z" };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    auto* const box = new QSpinBox(this);
    box->setRange(1, 100000);
    Name(box, tr("Voxels along %1").arg(axes[axis]), tr("x varies fastest in the file"));
    this->connect(box, qOverload<int>(&QSpinBox::valueChanged), this, &RawImportDialog::TakeLayout);
    row->addWidget(box);
    this->Dimensions[axis] = box;
  }
  form->addRow(tr("Voxels"), row);
  this->Type = new QComboBox(this);
  Name(this->Type, tr("Type"),
    tr("What one voxel is: whole numbers with or without sign, or floating point"));
  this->Type->addItems(QString(ScalarTypeNames()).split(' '));
  form->addRow(tr("Type"), this->Type);
  this->Spacing = new VectorEdit({ 1e-6, 1e6, 6 }, this);
  this->Spacing->SetNames(tr("Spacing"),
    tr("Distance between voxels along x, y and z, in millimetres for most scanners"));
  form->addRow(tr("Spacing"), this->Spacing);
  this->ByteOrder = new QComboBox(this);
  this->ByteOrder->addItems({ tr("Little endian (PC)"), tr("Big endian") });
  Name(this->ByteOrder, tr("Byte order"), tr("If the picture looks like noise, try the other one"));
  form->addRow(tr("Byte order"), this->ByteOrder);
  this->Header = new QSpinBox(this);
  this->Header->setRange(0, std::numeric_limits<int>::max());
  Name(this->Header, tr("Header bytes"), tr("Bytes before the first voxel"));
  form->addRow(tr("Header bytes"), this->Header);
  this->connect(
    this->Header, qOverload<int>(&QSpinBox::valueChanged), this, &RawImportDialog::TakeLayout);
  for (QComboBox* box : { this->Type, this->ByteOrder })
  {
    this->connect(
      box, qOverload<int>(&QComboBox::currentIndexChanged), this, &RawImportDialog::TakeLayout);
  }
  this->connect(this->Spacing, &VectorEdit::edited, this,
    [this](const Vector3& spacing) { this->Layout.Spacing = spacing; });
}

//------------------------------------------------------------------------------
void RawImportDialog::ShowLayout()
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const QSignalBlocker blocker(this->Dimensions[axis]);
    this->Dimensions[axis]->setValue(this->Layout.Dimensions[axis]);
  }
  const QSignalBlocker type(this->Type);
  this->Type->setCurrentText(QString::fromStdString(this->Layout.ScalarType));
  const QSignalBlocker order(this->ByteOrder);
  this->ByteOrder->setCurrentIndex(this->Layout.BigEndian ? 1 : 0);
  const QSignalBlocker header(this->Header);
  this->Header->setValue(static_cast<int>(this->Layout.HeaderBytes));
  this->Spacing->ShowVector(this->Layout.Spacing);
  this->CheckSize();
}

//------------------------------------------------------------------------------
void RawImportDialog::TakeLayout()
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Layout.Dimensions[axis] = this->Dimensions[axis]->value();
  }
  this->Layout.ScalarType = this->Type->currentText().toStdString();
  this->Layout.BigEndian = this->ByteOrder->currentIndex() == 1;
  this->Layout.HeaderBytes = static_cast<std::uint64_t>(this->Header->value());
  this->CheckSize();
}

//------------------------------------------------------------------------------
void RawImportDialog::CheckSize()
{
  const std::uint64_t bytes = this->Layout.Bytes();
  const bool fits = bytes == this->FileBytes;
  QString text = tr("This is the file's size exactly.");
  if (bytes > this->FileBytes)
  {
    text =
      tr("This needs %1, %2 more than the file has.")
        .arg(Bytes(bytes), QLocale().toString(static_cast<qulonglong>(bytes - this->FileBytes)));
  }
  else if (!fits)
  {
    text =
      tr("This needs %1; the file has %2 more.")
        .arg(Bytes(bytes), QLocale().toString(static_cast<qulonglong>(this->FileBytes - bytes)));
  }
  this->Verdict->setText(text);
  const bool dark = this->palette().color(QPalette::Window).lightness() < 128;
  const QString good = dark ? "color: #6fcf97;" : "color: #1e7145;";
  const QString bad = dark ? "color: #ff8a80;" : "color: #b03024;";
  this->Verdict->setStyleSheet(fits ? good : bad);
  this->Buttons->button(QDialogButtonBox::Open)->setEnabled(fits);
}

}
