#include "EnvironmentTextures.h"

#include "MatrixUniforms.h"
#include "OpenGLEnumerants.h"
#include "TextureSampling.h"

#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkVolumeMaterial.h"

#include <algorithm>

namespace penumbra
{
namespace
{
bool Load(vtkTextureObject* texture, vtkOpenGLRenderWindow* window, CubeMap map)
{
  std::array<void*, 6> faces;
  std::transform(map.Faces.begin(), map.Faces.end(), faces.begin(),
    [](std::vector<float>& face) { return face.data(); });
  ResetTexture(texture, window, vtkTextureObject::Linear);
  return texture->CreateCubeFromRaw(map.Size, map.Size, 3, VTK_FLOAT, faces.data());
}

vtkMTimeType GetTime(const std::vector<vtkSmartPointer<vtkImageData>>& images)
{
  vtkMTimeType time = 0;
  for (const auto& image : images)
  {
    time = image ? std::max(time, image->GetMTime()) : time;
  }
  return time;
}

}

//------------------------------------------------------------------------------
bool EnvironmentTextures::UpdateMap(
  vtkOpenGLRenderWindow* window, vtkVolumeMaterial* material, std::string& reason)
{
  const auto& images = material->GetEnvironmentMap();
  const vtkMTimeType time = GetTime(images);
  if (images != this->Images || time != this->ImagesTime)
  {
    this->Release(window);
    this->Images = images;
    this->ImagesTime = time;
    this->Reason = "the material has none";
    const std::vector<vtkImageData*> pointers(images.begin(), images.end());
    const auto map = pointers.empty() ? std::nullopt : MakeEnvironmentMap(pointers, this->Reason);
    this->Map = map.value_or(EnvironmentMap{});
    this->Mean = map ? MeanRadiance(*map) : std::array<double, 3>{};
  }
  reason = this->Reason;
  return !this->Map.Images.empty();
}

//------------------------------------------------------------------------------
bool EnvironmentTextures::Update(
  vtkOpenGLRenderWindow* window, vtkVolumeMaterial* material, std::string& reason)
{
  if (!this->UpdateMap(window, material, reason))
  {
    return false;
  }
  bool held = true;
  if (material->GetDiffuse(0) > 0.0 && !this->Diffuse->GetHandle())
  {
    held = Load(this->Diffuse, window, FilterDiffuse(this->Map));
  }
  const double power = material->GetSpecularPower(0);
  if (material->GetSpecular(0) > 0.0 && (power != this->Power || !this->Specular->GetHandle()))
  {
    held = Load(this->Specular, window, FilterSpecular(this->Map, power)) && held;
    this->Power = power;
  }
  reason = held ? "" : "the graphics card cannot hold it";
  return held;
}

//------------------------------------------------------------------------------
std::vector<vtkTextureObject*> EnvironmentTextures::GetLoaded() const
{
  std::vector<vtkTextureObject*> loaded;
  for (vtkTextureObject* texture : { this->Diffuse.Get(), this->Specular.Get() })
  {
    if (texture->GetHandle())
    {
      loaded.push_back(texture);
    }
  }
  return loaded;
}

//------------------------------------------------------------------------------
// A lookup near a face's edge takes texels of the next face.
void EnvironmentTextures::Activate(vtkOpenGLRenderWindow* window)
{
  window->GetState()->vtkglEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  for (vtkTextureObject* texture : this->GetLoaded())
  {
    texture->Activate();
  }
}

//------------------------------------------------------------------------------
void EnvironmentTextures::Deactivate()
{
  for (vtkTextureObject* texture : this->GetLoaded())
  {
    texture->Deactivate();
  }
}

//------------------------------------------------------------------------------
void EnvironmentTextures::SetUniforms(vtkShaderProgram* program) const
{
  SetSampler(program, "scene_environmentDiffuse", this->Diffuse);
  SetSampler(program, "scene_environmentSpecular", this->Specular);
  SetUniform(program, "scene_fadedRadiance", this->Mean);
}

//------------------------------------------------------------------------------
void EnvironmentTextures::Release(vtkOpenGLRenderWindow* window)
{
  this->Diffuse->ReleaseGraphicsResources(window);
  this->Specular->ReleaseGraphicsResources(window);
  this->Images.clear();
  this->Map.Images.clear();
  this->ImagesTime = 0;
}

}
