/**
 * @file    LightUniforms.h
 * @brief   the lights of a scene as the shader takes them
 */

#ifndef LightUniforms_h
#define LightUniforms_h

#include "LightSpace.h"
#include "LightingRequirements.h"
#include "VolumePlacement.h"

#include <array>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace penumbra
{

struct OpacityMapPlan;

/// What is kept of a light's shadow depends on besides the matter: where the light comes from,
/// where the rays begin and the optical depth that makes a hard shadow.
struct ShadowCaster
{
  std::array<float, 4> Place{}; ///< position and 1, or direction of the shadow ray and 0
  float Begin = 0.0f;
  float Enough = 0.0f;
  bool Hard = false;
  bool FirstHit = false; ///< kept as the place where the hard shadow begins

  bool operator==(const ShadowCaster& other) const;
  bool operator!=(const ShadowCaster& other) const { return !(*this == other); }
};

/// One entry per light that matters, sorted by kind and shadow state. See Lights.glsl.
struct LightUniforms
{
  using Vector3f = std::array<float, 3>;
  using Vector2f = std::array<float, 2>;
  using Vector4f = std::array<float, 4>;

  std::vector<Vector3f> Position;
  std::vector<Vector3f> Direction;
  std::vector<Vector3f> Diffuse;
  std::vector<Vector3f> Specular;
  std::vector<Vector3f> Attenuation;
  std::vector<Vector2f> Cone;
  std::vector<Vector2f> Shadow;
  std::vector<Vector4f> ShadowComponent; ///< with a shadow volume
  std::vector<Vector2f> ShadowVolume;
  std::vector<Vector4f> MapAxes; ///< with shadow maps, 3 a light
  std::vector<Vector4f> Map;
  std::vector<Vector4f> Layers; ///< of opacity shadow maps
  Vector3f Ambient{};

  /// ambient: sum of the lights' ambient colours; factor: the material's.
  void SetAmbient(const std::array<double, 3>& ambient, double factor);
  void Set(vtkShaderProgram* program) const;

  /// The lights with a shadow, in their order among the others; requirements: those of the same
  /// lights.
  std::vector<ShadowCaster> GetShadowCasters(const LightingRequirements& requirements) const;
  /// Root of the sum of squares of what lights with a shadow add at most, of white.
  double GetShadowedBrightness(const LightingRequirements& requirements) const;
  /// Looks the visibility of the first casters up in a shadow volume of this many blocks, beyond a
  /// length that is marched directly; the others' rays are marched whole.
  void LookUpVolume(
    const LightingRequirements& requirements, int casters, int blocks, double marchedLength);
  /// The same in maps, of the casters' light spaces.
  void LookUpMaps(const LightingRequirements& requirements, const std::vector<LightSpace>& spaces,
    double marchedLength);
  /// Where their layers are, of opacity shadow maps.
  void LookUpLayers(const LightingRequirements& requirements, const std::vector<LightSpace>& spaces,
    const OpacityMapPlan& plan);

  /// How many lights fit into the uniforms of a fragment shader. OpenGL 3.2 guarantees 16 of them;
  /// the drivers of graphics cards hold well over a hundred.
  static int GetLargestNumber(vtkOpenGLRenderWindow* window);
};

/// Adds those of all lights that are on and matter to collected, as many as the largest number; how
/// many are left out.
int CollectLights(vtkLightCollection* all, vtkVolumeProperty* property, int largestNumber,
  vtkLightCollection* collected);

/// The lights of a collection that are on and matter; ambient light is set apart, since lights that
/// do not matter otherwise give it too. cameraDirection: unit direction of projection, along which
/// headlights shine.
LightUniforms MakeLightUniforms(vtkLightCollection* lights, vtkVolumeProperty* property,
  const VolumePlacement& placement, const Vector3& cameraDirection);

}

#endif
