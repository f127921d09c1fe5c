#include "KeptShadowDifference.h"

#include "Catch.h"

namespace penumbra
{

//------------------------------------------------------------------------------
ImageDifference DifferenceFromRays(IlluminatedScene& scene, int technique)
{
  scene.Mapper->SetShadowTechniqueToRays();
  scene.Mapper->SetShadowSampleDistance(0.5);
  const auto rays = scene.Render();
  scene.Mapper->SetShadowTechnique(technique);
  scene.Mapper->SetShadowSampleDistance(1.0);
  const auto kept = scene.Render();
  CHECK(scene.Mapper->GetShadowBytes() > 0);
  return CompareImages(kept, rays);
}

}
