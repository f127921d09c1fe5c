#include "SceneDescription.h"

namespace penumbra
{

//------------------------------------------------------------------------------
LightDescription SceneDescription::DefaultLight()
{
  LightDescription headlight;
  headlight.Type = LightType::Headlight;
  return headlight;
}

}
