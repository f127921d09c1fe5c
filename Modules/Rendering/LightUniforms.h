/**
 * @file    LightUniforms.h
 * @brief   the lights of a scene as the shader takes them
 */

#ifndef LightUniforms_h
#define LightUniforms_h

#include "LightingRequirements.h"
#include "VolumePlacement.h"

#include <array>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace penumbra
{

/// One entry per light that matters, sorted by kind and shadow state. See Lights.glsl.
struct LightUniforms
{
  using Vector3f = std::array<float, 3>;
  using Vector2f = std::array<float, 2>;

  std::vector<Vector3f> Position;
  std::vector<Vector3f> Direction;
  std::vector<Vector3f> Diffuse;
  std::vector<Vector3f> Specular;
  std::vector<Vector3f> Attenuation;
  std::vector<Vector2f> Cone;
  std::vector<Vector2f> Shadow;
  Vector3f Ambient{};

  /// ambient: sum of the lights' ambient colours; factor: the material's.
  void SetAmbient(const std::array<double, 3>& ambient, double factor);
  void Set(vtkShaderProgram* program) const;

  /// How many lights fit into the uniforms of a fragment shader. OpenGL 3.2 guarantees 27 of them;
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
