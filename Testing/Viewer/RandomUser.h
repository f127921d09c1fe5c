/**
 * @class   RandomUser
 * @brief   anything that a user of the viewer may do, at random; the same for the same seed
 */

#ifndef RandomUser_h
#define RandomUser_h

#include "ViewerSession.h"

#include <random>

namespace penumbra
{

class RandomUser
{
public:
  RandomUser(ViewerSession& session, unsigned int seed);

  void EditOnce();

private:
  int Whole(int count) { return static_cast<int>(this->Generator() % count); }
  double Part() { return this->Generator() / 4294967296.0; }
  Vector3 Color() { return { this->Part(), this->Part(), this->Part() }; }
  void Trigger(const QString& name);
  void Edit(const std::function<void(SceneDescription&)>& change);
  void ChangeLight();
  void MoveOpacityPoint();
  void ChangeMaterial();
  void Clip();
  void MoveCamera();

  ViewerSession& Session;
  std::mt19937 Generator;
  LightDescription Light;
};

}

#endif
