#include "SeriesDialog.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>

namespace penumbra
{

//------------------------------------------------------------------------------
SeriesDialog::SeriesDialog(const std::vector<SeriesFacts>& series, QWidget* parent)
  : QDialog(parent)
  , Series(series)
  , Table(new QTableWidget(static_cast<int>(series.size()), 4, this))
{
  this->setWindowTitle(tr("Choose a series"));
  this->resize(640, 300);
  auto* const column = new QVBoxLayout(this);
  column->addWidget(new QLabel(
    tr("The folder holds several series, the one with most voxels first. Which shall be shown?")));
  this->Table->setObjectName("seriesTable");
  this->Table->setAccessibleName(tr("Series"));
  this->Table->setHorizontalHeaderLabels(
    { tr("Modality"), tr("Description"), tr("Slices"), tr("Size in pixels") });
  this->Table->verticalHeader()->hide();
  this->Table->setSelectionBehavior(QAbstractItemView::SelectRows);
  this->Table->setSelectionMode(QAbstractItemView::SingleSelection);
  this->Table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  this->Table->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
  for (int row = 0; row < static_cast<int>(series.size()); ++row)
  {
    const SeriesFacts& facts = series[static_cast<std::size_t>(row)];
    const QString texts[] = { QString::fromStdString(facts.Modality),
      QString::fromStdString(facts.Description), QString::number(facts.Slices),
      QString::fromUtf8("%1\u2009\u00d7\u2009%2").arg(facts.Columns).arg(facts.Rows) };
    for (int field = 0; field < 4; ++field)
    {
      auto* const item = new QTableWidgetItem(texts[field]);
      item->setToolTip(texts[field]);
      item->setTextAlignment((field < 2 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
      this->Table->setItem(row, field, item);
    }
  }
  this->Table->setCornerButtonEnabled(false);
  this->Table->selectRow(0);
  column->addWidget(this->Table);
  auto* const buttons =
    new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel, this);
  column->addWidget(buttons);
  this->connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  this->connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  this->connect(this->Table, &QTableWidget::cellDoubleClicked, this, &QDialog::accept);
}

//------------------------------------------------------------------------------
const SeriesFacts& SeriesDialog::GetChosen() const
{
  return this->Series[static_cast<std::size_t>(this->Table->currentRow())];
}

}
