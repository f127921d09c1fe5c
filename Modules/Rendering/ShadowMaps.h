/**
 * @file    ShadowMaps.h
 * @brief   the lights' shadow maps and deep shadow maps, as slices of one 3D texture
 *
 * Each light's map lies in the light's own space, with the function of one ray a texel.
 */

#ifndef ShadowMaps_h
#define ShadowMaps_h

#include "ShadowCache.h"
#include "ShadowMapPlan.h"

namespace penumbra
{

class ShadowMaps : public ShadowCache
{
public:
  /// Makes room for the plan; one of no lights gives it up. False where the graphics card has none.
  bool Allocate(vtkOpenGLRenderWindow* window, const ShadowMapPlan& plan);

  void SetUniforms(vtkShaderProgram* program, const DrawnScene& scene) override;

private:
  std::string GetSource(const LightingRequirements& requirements) const override;
  std::array<int, 2> GetSize() const override;
  int CountParts() const override;
  void FillPart(const Filling& filling, int slot, int part) override;

  ShadowMapPlan Plan;
};

}

#endif
