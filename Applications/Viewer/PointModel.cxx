#include "PointModel.h"

#include "ColorButton.h"
#include "SceneDocument.h"

#include <QColor>

#include <algorithm>

namespace penumbra
{
namespace
{
using Function = TransferFunctionDescription;

template <std::size_t N>
void Connect(PointAccess& access, std::optional<FunctionPoints<N>> Function::*member)
{
  access.Get = [member](const SceneDescription& scene)
  {
    Points points;
    if (const auto& function = scene.TransferFunction.*member)
    {
      for (const auto& point : *function)
      {
        points.emplace_back(point.begin(), point.end());
      }
    }
    return points;
  };
  access.Set = [member](SceneDescription& scene, const Points& points)
  {
    auto& function = (scene.TransferFunction.*member).emplace(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      std::copy(points[i].begin(), points[i].end(), function[i].begin());
    }
  };
}

QColor ColorOf(const Point& point)
{
  return ToQColor({ point[1], point[2], point[3] });
}

// Halfway to the next point, or a tenth of the function's extent beyond the last.
Point PointAfter(const Points& points, std::size_t row)
{
  Point point = points[row];
  if (row + 1 < points.size())
  {
    for (std::size_t i = 0; i < point.size(); ++i)
    {
      point[i] = 0.5 * (point[i] + points[row + 1][i]);
    }
    return point;
  }
  const double extent = points.back()[0] - points.front()[0];
  point[0] += extent > 0.0 ? 0.1 * extent : 1.0;
  return point;
}
}

//------------------------------------------------------------------------------
PointAccess AccessToOpacity()
{
  PointAccess access{ QObject::tr("opacity"), QObject::tr("Value"), QObject::tr("Opacity"),
    QObject::tr("Matter of this value is so opaque, 0 to 1; in between, it changes evenly."), false,
    {}, {} };
  Connect<1>(access, &Function::Opacity);
  return access;
}

//------------------------------------------------------------------------------
PointAccess AccessToColor()
{
  PointAccess access{ QObject::tr("colour"), QObject::tr("Value"), QObject::tr("Colour"),
    QObject::tr("Matter of this value has this colour; in between, a mixture."), true, {}, {} };
  Connect<3>(access, &Function::Color);
  return access;
}

//------------------------------------------------------------------------------
PointAccess AccessToGradientOpacity()
{
  PointAccess access{ QObject::tr("gradient opacity"), QObject::tr("Gradient"),
    QObject::tr("Factor"),
    QObject::tr("Where values change by so much per voxel, opacity is multiplied by this, 0 to 1."),
    false, {}, {} };
  Connect<1>(access, &Function::GradientOpacity);
  return access;
}

//------------------------------------------------------------------------------
PointModel::PointModel(SceneDocument* document, const PointAccess& access, QObject* parent)
  : QAbstractTableModel(parent)
  , Document(document)
  , Access(access)
{
  this->connect(document, &SceneDocument::changed, this, &PointModel::Refresh);
}

//------------------------------------------------------------------------------
void PointModel::Refresh()
{
  const Points points = this->Access.Get(this->Document->GetScene());
  if (points.size() == this->Rows.size())
  {
    this->Rows = points;
    emit this->dataChanged(this->index(0, 0), this->index(this->rowCount() - 1, 1));
    return;
  }
  this->beginResetModel();
  this->Rows = points;
  this->endResetModel();
}

//------------------------------------------------------------------------------
int PointModel::rowCount(const QModelIndex& parent) const
{
  return parent.isValid() ? 0 : static_cast<int>(this->Rows.size());
}

//------------------------------------------------------------------------------
int PointModel::columnCount(const QModelIndex& parent) const
{
  return parent.isValid() ? 0 : 2;
}

//------------------------------------------------------------------------------
QVariant PointModel::headerData(int section, Qt::Orientation orientation, int role) const
{
  if (role != Qt::DisplayRole || orientation != Qt::Horizontal)
  {
    return {};
  }
  return section == 0 ? this->Access.Value : this->Access.Result;
}

//------------------------------------------------------------------------------
Qt::ItemFlags PointModel::flags(const QModelIndex& index) const
{
  return QAbstractTableModel::flags(index) | Qt::ItemIsEditable;
}

//------------------------------------------------------------------------------
QVariant PointModel::data(const QModelIndex& index, int role) const
{
  const Point& point = this->Rows[static_cast<std::size_t>(index.row())];
  const bool isColor = this->Access.IsColor && index.column() == 1;
  if (isColor && role == Qt::DecorationRole)
  {
    return ColorOf(point);
  }
  if (role == Qt::EditRole)
  {
    return isColor ? QVariant(ColorOf(point).name()) : QVariant(point[index.column()]);
  }
  if (role == Qt::DisplayRole)
  {
    return isColor ? ColorOf(point).name() : QString::number(point[index.column()], 'g', 6);
  }
  return {};
}

//------------------------------------------------------------------------------
bool PointModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
  if (role != Qt::EditRole || value == this->data(index, Qt::EditRole))
  {
    return false;
  }
  const auto row = static_cast<std::size_t>(index.row());
  if (this->Access.IsColor && index.column() == 1)
  {
    const QColor color(value.toString());
    if (!color.isValid())
    {
      return false;
    }
    this->SetColor(index.row(), FromQColor(color));
    return true;
  }
  Points points = this->Rows;
  points[row][static_cast<std::size_t>(index.column())] = value.toDouble();
  const Point edited = points[row];
  std::stable_sort(points.begin(), points.end(),
    [](const Point& left, const Point& right) { return left[0] < right[0]; });
  this->Edit(tr("change of %1").arg(this->Access.Name), points);
  emit this->moved(
    static_cast<int>(std::find(points.begin(), points.end(), edited) - points.begin()));
  return true;
}

//------------------------------------------------------------------------------
void PointModel::SetColor(int row, const Vector3& color)
{
  Points points = this->Rows;
  std::copy(color.begin(), color.end(), points[static_cast<std::size_t>(row)].begin() + 1);
  this->Edit(tr("change of %1").arg(this->Access.Name), points);
}

//------------------------------------------------------------------------------
int PointModel::Add(int row)
{
  Points points = this->Rows;
  points.insert(points.begin() + row + 1, PointAfter(points, static_cast<std::size_t>(row)));
  this->Edit(tr("new point of %1").arg(this->Access.Name), points);
  return row + 1;
}

//------------------------------------------------------------------------------
void PointModel::Remove(int row)
{
  Points points = this->Rows;
  points.erase(points.begin() + row);
  this->Edit(tr("removal of a point of %1").arg(this->Access.Name), points);
}

//------------------------------------------------------------------------------
void PointModel::Edit(const QString& text, const Points& points)
{
  this->Document->Edit(text, [&](SceneDescription& scene) { this->Access.Set(scene, points); });
}

}
