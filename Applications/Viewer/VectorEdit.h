/**
 * @class   VectorEdit
 * @brief   three number boxes for a point or a direction
 */

#ifndef VectorEdit_h
#define VectorEdit_h

#include "NumberBox.h"
#include "Vector3.h"

#include <QWidget>

#include <array>

namespace penumbra
{

class VectorEdit : public QWidget
{
  Q_OBJECT
public:
  explicit VectorEdit(const NumberRange& range, QWidget* parent = nullptr);

  void ShowVector(const Vector3& vector);
  void SetNames(const QString& name, const QString& tip);

signals:
  /// By the user.
  void edited(const penumbra::Vector3& vector);

private:
  std::array<NumberBox*, 3> Boxes{};
  Vector3 Vector{};
};

}

#endif
