/**
 * @file    EnvironmentTextures.h
 * @brief   a material's surroundings as filtered cube maps, made again only when they change
 */

#ifndef EnvironmentTextures_h
#define EnvironmentTextures_h

#include "EnvironmentMap.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <array>
#include <string>
#include <vector>

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkVolumeMaterial;

namespace penumbra
{

class EnvironmentTextures
{
public:
  /// Filters and loads the material's environment map for its factors and power. False where there
  /// is none that can be shown; `reason` then says why.
  bool Update(vtkOpenGLRenderWindow* window, vtkVolumeMaterial* material, std::string& reason);

  void Activate(vtkOpenGLRenderWindow* window);
  void Deactivate();
  void SetUniforms(vtkShaderProgram* program) const;
  void Release(vtkOpenGLRenderWindow* window);

private:
  bool UpdateMap(vtkOpenGLRenderWindow* window, vtkVolumeMaterial* material, std::string& reason);
  std::vector<vtkTextureObject*> GetLoaded() const;

  EnvironmentMap Map;
  std::vector<vtkSmartPointer<vtkImageData>> Images;
  vtkMTimeType ImagesTime = 0;
  std::string Reason = "the material has none";
  std::array<double, 3> Mean{};
  double Power = -1.0;
  vtkNew<vtkTextureObject> Diffuse;
  vtkNew<vtkTextureObject> Specular;
};

}

#endif
