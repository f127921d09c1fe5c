/**
 * @file    DrawnScene.h
 * @brief   one picture of a volume as its shader sees it
 */

#ifndef DrawnScene_h
#define DrawnScene_h

#include "LightUniforms.h"
#include "LightingRequirements.h"
#include "MarchingPlan.h"
#include "MaterialUniforms.h"
#include "OpacityMapPlan.h"
#include "ShadowMapPlan.h"
#include "ShadowVolumePlan.h"
#include "ShadowingMatter.h"
#include "ViewRays.h"
#include "VolumePlacement.h"

#include <array>
#include <vector>

class vtkShaderProgram;

namespace penumbra
{

struct DrawnScene
{
  VolumePlacement Placement;
  ViewRays Rays;
  LightingRequirements Requirements;
  LightUniforms Lights;
  MaterialUniforms Material;
  std::vector<std::array<double, 4>> ClippingPlanes; ///< in texture coordinates
  Vector3 CroppingLow{};                             ///< in texture coordinates
  Vector3 CroppingHigh{};
  CroppingKind Cropping = CroppingKind::None;
  int CroppingFlags = 0;       ///< vtkVolumeMapper's region flags
  bool AnythingVisible = true; ///< false where cropping hides the whole volume
  double UnitDistance = 1.0;   ///< of the scalar opacity, in the volume's own lengths
  MarchingPlan Plan;
  double OpaqueEnough = 1.0;               ///< where view rays end, as what lies behind is hidden
  std::vector<ShadowCaster> ShadowCasters; ///< whose shadows are looked up
  bool ShadowsMove = false;                ///< and are kept coarser until all is still
  ShadowingMatter Matter;                  ///< what kept shadows depend on
  std::vector<LightSpace> LightSpaces;     ///< theirs, with maps
  ShadowVolumePlan VolumeOfShadows;
  ShadowMapPlan MapsOfShadows;
  OpacityMapPlan LayersOfShadows;

  /// Sets all uniforms that do not depend on a texture or on the part of the picture that is drawn.
  void SetUniforms(vtkShaderProgram* program) const;

private:
  void SetGeometryUniforms(vtkShaderProgram* program) const;
  void SetRayUniforms(vtkShaderProgram* program) const;
  void SetVisibilityUniforms(vtkShaderProgram* program) const;
};

}

#endif
