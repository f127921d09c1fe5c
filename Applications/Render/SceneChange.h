/**
 * @file    SceneChange.h
 * @brief   small changes of a scene between frames, for measuring what each costs
 */

#ifndef SceneChange_h
#define SceneChange_h

#include <cstddef>

namespace penumbra
{

class SceneRendering;

enum class SceneChange
{
  /// The first light turns by one degree about the view-up axis, one with a place about the focal
  /// point.
  Light,
  /// The first light's colours fade by a hundredth.
  LightColour,
  /// The opacity function moves up by a thousandth of the data's range.
  Opacity,
  /// Azimuth of one degree.
  Camera
};

/// @throw InputError where the change is one of a light and there is none.
void CheckChange(SceneChange change, std::size_t numberOfLights);

/// The scene must have passed CheckChange.
void ChangeScene(SceneRendering& rendering, SceneChange change);

}

#endif
