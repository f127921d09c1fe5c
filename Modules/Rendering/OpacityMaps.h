/**
 * @file    OpacityMaps.h
 * @brief   the lights' opacity shadow maps, as blocks of layers of one 3D texture
 *
 * Each light's map lies in the light's own space (Kim and Neumann 2001, "Opacity shadow maps"):
 * along the ray of each texel it tells at even distances how dark it has grown. It is made some
 * layers at a time, each from the one before.
 */

#ifndef OpacityMaps_h
#define OpacityMaps_h

#include "OpacityMapPlan.h"
#include "ShadowCache.h"

namespace penumbra
{

class OpacityMaps : public ShadowCache
{
public:
  /// Lets coarse maps lie in the texture of finer ones that is there, within so many bytes: those
  /// of what moves, until it is still. A large texture takes longer to make than to fill.
  void ShareTexture(OpacityMapPlan& plan, std::size_t largestBytes) const;

  /// Makes room for the plan; one of no lights gives it up. False where the graphics card has none.
  bool Allocate(vtkOpenGLRenderWindow* window, const OpacityMapPlan& plan);

  void SetUniforms(vtkShaderProgram* program, const DrawnScene& scene) override;
  void Release(vtkOpenGLRenderWindow* window) override;

private:
  std::string GetSource(const LightingRequirements& requirements) const override;
  std::array<int, 2> GetSize() const override;
  int CountParts() const override;
  void FillPart(const Filling& filling, int slot, int part) override;

  bool ReserveDepths(vtkOpenGLRenderWindow* window);

  OpacityMapPlan Plan;
  /// The optical depth as far as layers are made, read by one draw and written by the next.
  vtkNew<vtkTextureObject> Depths[2];
};

}

#endif
