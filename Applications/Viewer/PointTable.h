/**
 * @class   PointTable
 * @brief   the points of a function as a table that is edited by the keyboard alone
 *
 * F2 or typing edits a cell; buttons add and remove points. It is also what screen readers read of
 * the function.
 */

#ifndef PointTable_h
#define PointTable_h

#include "PointModel.h"

#include <QWidget>

class QTableView;
class QToolButton;

namespace penumbra
{

class PointTable : public QWidget
{
  Q_OBJECT
public:
  /// `name` is the table's for screen readers, and its object name.
  PointTable(const QString& name, SceneDocument* document, const PointAccess& access,
    QWidget* parent = nullptr);

private:
  QWidget* MakeButtons(const QString& name, bool withColors);
  int GetRow() const;
  void GoTo(int row);
  void Add();
  void Remove();
  void ChooseColor();
  void Refresh();

  PointModel* Model;
  QTableView* Table;
  QToolButton* AddButton = nullptr;
  QToolButton* RemoveButton = nullptr;
  QToolButton* ColorButton = nullptr;
};

}

#endif
