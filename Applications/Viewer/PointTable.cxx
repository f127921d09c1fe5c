#include "PointTable.h"

#include "ColorButton.h"
#include "NumberBox.h"
#include "PanelButton.h"

#include <QColorDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QToolButton>

namespace penumbra
{
namespace
{
constexpr double LargestValue = 1e9;
constexpr int Decimals = 4;
constexpr int RowHeight = 24;

// Numbers are entered as everywhere in the window, the same in every language.
class NumberDelegate : public QStyledItemDelegate
{
public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QWidget* createEditor(
    QWidget* parent, const QStyleOptionViewItem& option, const QModelIndex& index) const override
  {
    const QVariant value = index.data(Qt::EditRole);
    if (value.userType() != QMetaType::Double)
    {
      return QStyledItemDelegate::createEditor(parent, option, index);
    }
    const bool isPart = index.column() == 1;
    auto* const box = new NumberBox(
      { isPart ? 0.0 : -LargestValue, isPart ? 1.0 : LargestValue, Decimals }, parent);
    box->setFrame(false);
    box->setButtonSymbols(QAbstractSpinBox::NoButtons);
    return box;
  }

  void setModelData(
    QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override
  {
    auto* const box = qobject_cast<NumberBox*>(editor);
    if (!box)
    {
      QStyledItemDelegate::setModelData(editor, model, index);
      return;
    }
    box->interpretText();
    NumberBox unedited({ box->minimum(), box->maximum(), Decimals });
    unedited.setValue(index.data(Qt::EditRole).toDouble());
    if (box->value() != unedited.value()) // what was only looked at is not rounded
    {
      model->setData(index, box->value(), Qt::EditRole);
    }
  }
};
}

//------------------------------------------------------------------------------
PointTable::PointTable(
  const QString& name, SceneDocument* document, const PointAccess& access, QWidget* parent)
  : QWidget(parent)
  , Model(new PointModel(document, access, this))
  , Table(new QTableView(this))
{
  this->Table->setObjectName(name);
  this->Table->setAccessibleName(name);
  this->Table->setToolTip(access.Tip + tr(" F2: edit."));
  this->Table->setModel(this->Model);
  this->Table->setItemDelegate(new NumberDelegate(this->Table));
  this->Table->setTabKeyNavigation(false); // Tab leaves the table; arrow keys move in it
  this->Table->setSelectionMode(QAbstractItemView::SingleSelection);
  this->Table->setTextElideMode(Qt::ElideNone);
  this->Table->verticalHeader()->hide();
  this->Table->verticalHeader()->setDefaultSectionSize(RowHeight);
  this->Table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  this->Table->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
  this->Table->setMinimumHeight(4 * RowHeight);
  auto* const column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(3);
  column->addWidget(this->Table, 1);
  column->addWidget(this->MakeButtons(name, access.IsColor));
  this->connect(this->Model, &PointModel::moved, this, &PointTable::GoTo);
  this->connect(this->Model, &QAbstractItemModel::modelReset, this, &PointTable::Refresh);
  this->Refresh();
}

//------------------------------------------------------------------------------
QWidget* PointTable::MakeButtons(const QString& name, bool withColors)
{
  auto* const row = new QWidget(this);
  auto* const layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(3);
  this->AddButton = MakePanelButton(
    tr("Add"), tr("Put a point after the selected one; the picture stays as it is"), row);
  this->RemoveButton = MakePanelButton(tr("Remove"), tr("Remove the selected point"), row);
  layout->addWidget(this->AddButton);
  layout->addWidget(this->RemoveButton);
  this->connect(this->AddButton, &QToolButton::clicked, this, &PointTable::Add);
  this->connect(this->RemoveButton, &QToolButton::clicked, this, &PointTable::Remove);
  this->AddButton->setObjectName(name + " add");
  this->RemoveButton->setObjectName(name + " remove");
  if (withColors)
  {
    this->ColorButton = MakePanelButton(tr("Pick"), tr("Pick the selected point's colour"), row);
    layout->addWidget(this->ColorButton);
    this->connect(this->ColorButton, &QToolButton::clicked, this, &PointTable::ChooseColor);
  }
  return row;
}

//------------------------------------------------------------------------------
int PointTable::GetRow() const
{
  const int row = this->Table->currentIndex().row();
  return row < 0 ? this->Model->rowCount() - 1 : row;
}

//------------------------------------------------------------------------------
void PointTable::GoTo(int row)
{
  const int column = std::max(this->Table->currentIndex().column(), 0);
  this->Table->setCurrentIndex(this->Model->index(row, column));
}

//------------------------------------------------------------------------------
void PointTable::Add()
{
  this->GoTo(this->Model->Add(this->GetRow()));
}

//------------------------------------------------------------------------------
void PointTable::Remove()
{
  const int row = this->GetRow();
  this->Model->Remove(row);
  this->GoTo(std::min(row, this->Model->rowCount() - 1));
}

//------------------------------------------------------------------------------
void PointTable::ChooseColor()
{
  const int row = this->GetRow();
  const QColor before(this->Model->index(row, 1).data(Qt::EditRole).toString());
  const QColor chosen = QColorDialog::getColor(before, this);
  if (chosen.isValid())
  {
    this->Model->SetColor(row, FromQColor(chosen));
  }
}

//------------------------------------------------------------------------------
void PointTable::Refresh()
{
  const int count = this->Model->rowCount();
  this->AddButton->setEnabled(count > 0);
  this->RemoveButton->setEnabled(count > 1);
  if (this->ColorButton)
  {
    this->ColorButton->setEnabled(count > 0);
  }
}

}
