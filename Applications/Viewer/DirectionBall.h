/**
 * @class   DirectionBall
 * @brief   a ball that is lit like the scene: drag the light to where it shall come from
 *
 * The view looks at the ball. Within it the light comes from the front; in the ring around it, from
 * behind. The arrow keys turn the light too.
 */

#ifndef DirectionBall_h
#define DirectionBall_h

#include "Vector3.h"

#include <QWidget>

namespace penumbra
{

class DirectionBall : public QWidget
{
  Q_OBJECT
public:
  explicit DirectionBall(QWidget* parent = nullptr);

  /// Where the light comes from, to the right, up and towards the viewer; of unit length.
  void ShowDirection(const Vector3& toLight, const Vector3& color);
  const Vector3& GetDirection() const { return this->ToLight; }

  QSize sizeHint() const override { return { 190, 190 }; }

signals:
  /// By the user.
  void edited(const penumbra::Vector3& toLight);

protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  double Radius() const;
  QPointF Middle() const;
  QPointF PlaceOf(const Vector3& toLight) const;
  Vector3 DirectionAt(const QPointF& place) const;
  QImage MakePicture() const;
  void Turn(const Vector3& toLight);

  Vector3 ToLight = { 0.0, 0.0, 1.0 };
  Vector3 Color = { 1.0, 1.0, 1.0 };
};

}

#endif
