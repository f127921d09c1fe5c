/**
 * @file PictureTest.h
 * @brief A picture against its baseline, and deliberate faults that the comparison must notice.
 */
#ifndef PictureTest_h
#define PictureTest_h

#include "IlluminatedScene.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace penumbra
{
using SceneMaker = std::function<std::unique_ptr<IlluminatedScene>()>;

struct Fault
{
  std::string Name;
  std::function<void(IlluminatedScene&)> Break;
};

/// The light shines from the other side.
Fault LightFromTheOtherSide();
/// No light casts a shadow.
Fault NoShadow();
/// All opacities are halved.
Fault HalfTheDensity();

/// Checks that the scene's picture is its baseline's and the reference integrator's, and that with
/// each of the faults it is not the baseline's.
void CheckPicture(
  const std::string& name, const SceneMaker& make, const std::vector<Fault>& faults);
}

#endif
