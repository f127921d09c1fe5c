/**
 * @class   PointModel
 * @brief   the points of a function of the scene as a table: a value, and an opacity or a colour
 */

#ifndef PointModel_h
#define PointModel_h

#include "SceneDescription.h"

#include <QAbstractTableModel>

#include <functional>
#include <vector>

namespace penumbra
{

class SceneDocument;

/// The value, then one number or red, green and blue. One length for all points of a function.
using Point = std::vector<double>;
using Points = std::vector<Point>;

struct PointAccess
{
  /// What the function is called, as in "change of opacity".
  QString Name;
  /// What the columns are called, and what the function does to the picture.
  ///@{
  QString Value;
  QString Result;
  QString Tip;
  ///@}
  /// Whether points have a colour instead of one number.
  bool IsColor;
  /// None where the scene has no such function.
  std::function<Points(const SceneDescription&)> Get;
  std::function<void(SceneDescription&, const Points&)> Set;
};

PointAccess AccessToOpacity();
PointAccess AccessToColor();
PointAccess AccessToGradientOpacity();

class PointModel : public QAbstractTableModel
{
  Q_OBJECT
public:
  PointModel(SceneDocument* document, const PointAccess& access, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

  /// Puts a point between this one and the next, or after the last, without a change of the
  /// function. Returns its row.
  int Add(int row);
  void Remove(int row);
  void SetColor(int row, const Vector3& color);

signals:
  /// A point that was edited is in this row now.
  void moved(int row);

private:
  void Refresh();
  void Edit(const QString& text, const Points& points);

  SceneDocument* Document;
  PointAccess Access;
  Points Rows;
};

}

#endif
