#include "RenderingModel.h"

#include "ReferenceScene.h"

#include <algorithm>

namespace penumbra::reference
{
namespace
{
OpticalModel GetOptics(const ReferenceScene& scene)
{
  return scene.Optics.value_or(
    scene.Property->GetShade() ? OpticalModel::SingleScattering : OpticalModel::AbsorptionEmission);
}
}

//------------------------------------------------------------------------------
RenderingModel::RenderingModel(const ReferenceScene& scene, double tolerance, int mostSamples)
  : Matter(scene)
  , Colors(MakeColorFunction(scene.Property))
  , Optics(GetOptics(scene))
  , Tolerance(tolerance)
  , MostSamples(mostSamples)
{
  if (this->IsLit())
  {
    this->Lighting.emplace(scene, this->Matter, ShadowShare * tolerance);
  }
}

//------------------------------------------------------------------------------
ShadedSample RenderingModel::Shade(const MatterSample& sample) const
{
  if (this->Lighting)
  {
    return this->Lighting->Shade(sample);
  }
  ShadedSample shaded;
  for (int channel = 0; channel < 3; ++channel)
  {
    shaded.Color[channel] = std::clamp(sample.Color[channel], 0.0, 1.0);
  }
  return shaded;
}

}
