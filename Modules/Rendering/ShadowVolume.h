/**
 * @file    ShadowVolume.h
 * @brief   optical depths towards the lights over the visible box, as a 3D texture
 *
 * Made slice by slice with the GLSL of the shadow rays.
 */

#ifndef ShadowVolume_h
#define ShadowVolume_h

#include "ShadowCache.h"
#include "ShadowVolumePlan.h"

namespace penumbra
{

class ShadowVolume : public ShadowCache
{
public:
  /// Makes room for the plan; one of no lights gives it up. False where the graphics card has none.
  bool Allocate(vtkOpenGLRenderWindow* window, const ShadowVolumePlan& plan);

  void SetUniforms(vtkShaderProgram* program, const DrawnScene& scene) override;

private:
  std::string GetSource(const LightingRequirements& requirements) const override;
  std::array<int, 2> GetSize() const override;
  int CountParts() const override;
  void FillPart(const Filling& filling, int slot, int part) override;

  ShadowVolumePlan Plan;
};

}

#endif
