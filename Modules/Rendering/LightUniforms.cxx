#include "LightUniforms.h"

#include "OpacityMapPlan.h"
#include "OpenGLEnumerants.h"
#include "TransferFunctionTable.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkVolumeLight.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
LightUniforms::Vector3f ToFloat(const Vector3& vector)
{
  return { static_cast<float>(vector[0]), static_cast<float>(vector[1]),
    static_cast<float>(vector[2]) };
}

LightUniforms::Vector3f Scaled(const double color[3], double factor)
{
  return ToFloat({ color[0] * factor, color[1] * factor, color[2] * factor });
}

template <typename Visitor>
void VisitLightsThatMatter(vtkLightCollection* lights, vtkVolumeProperty* property, Visitor visit)
{
  vtkCollectionSimpleIterator cursor;
  lights->InitTraversal(cursor);
  while (vtkLight* light = lights->GetNextLight(cursor))
  {
    if (light->GetSwitch() && LightMatters(light, property))
    {
      visit(light);
    }
  }
}

// The lights that matter, in the order of Lights.glsl; lights of one group keep the renderer's
// order.
std::vector<vtkLight*> SortLights(vtkLightCollection* lights, vtkVolumeProperty* property)
{
  std::vector<vtkLight*> sorted;
  VisitLightsThatMatter(lights, property, [&](vtkLight* light) { sorted.push_back(light); });
  const auto group = [](vtkLight* light)
  {
    return NumberOfShadowKinds * static_cast<int>(GetLightKind(light)) +
      static_cast<int>(GetShadowKind(light));
  };
  std::stable_sort(
    sorted.begin(), sorted.end(), [&](vtkLight* a, vtkLight* b) { return group(a) < group(b); });
  return sorted;
}

template <typename Visitor>
void VisitShadowedLights(const LightingRequirements& requirements, Visitor visit)
{
  int light = 0;
  for (int kind = 0; kind < NumberOfLightKinds; ++kind)
  {
    for (int shadow = 0; shadow < NumberOfShadowKinds; ++shadow)
    {
      for (int count = 0; count < requirements.Lights[kind][shadow]; ++count, ++light)
      {
        if (static_cast<ShadowKind>(shadow) != ShadowKind::None)
        {
          visit(light, static_cast<LightKind>(kind), static_cast<ShadowKind>(shadow));
        }
      }
    }
  }
}

Vector3 GetTravelDirection(vtkLight* light)
{
  double from[3];
  double to[3];
  light->GetTransformedPosition(from);
  light->GetTransformedFocalPoint(to);
  return Normalized({ to[0] - from[0], to[1] - from[1], to[2] - from[2] });
}

// Where the shadow ray begins and the optical depth beyond which a hard shadow is complete.
LightUniforms::Vector2f GetShadow(vtkLight* light, const VolumePlacement& placement)
{
  auto* volumeLight = vtkVolumeLight::SafeDownCast(light);
  if (!volumeLight)
  {
    return { 0.0f, 0.0f };
  }
  const double bias = volumeLight->GetShadowBias();
  return { static_cast<float>(bias >= 0.0 ? bias : placement.SmallestSpacing),
    static_cast<float>(ComputeExtinction(volumeLight->GetOpacityThreshold(), 1.0)) };
}

// Direction of a shadow ray in texture coordinates per length of the own frame.
Vector3 GetShadowDirection(const VolumePlacement& placement, const Vector3& towardsLight)
{
  const Vector3 direction = MultiplyDirection(placement.WorldToTexture, towardsLight);
  const double length = GetLength(MultiplyDirection(placement.TextureToOwn, direction));
  const double factor = length > 0.0 ? 1.0 / length : 0.0;
  return { direction[0] * factor, direction[1] * factor, direction[2] * factor };
}

void AddDirectional(
  LightUniforms& uniforms, const VolumePlacement& placement, const Vector3& travel)
{
  const Vector3 towardsLight = { -travel[0], -travel[1], -travel[2] };
  uniforms.Position.push_back(ToFloat(GetShadowDirection(placement, towardsLight)));
  uniforms.Direction.push_back(ToFloat(towardsLight));
}

void AddPositional(LightUniforms& uniforms, const VolumePlacement& placement, vtkLight* light)
{
  double position[3];
  light->GetTransformedPosition(position);
  uniforms.Position.push_back(
    ToFloat(MultiplyPoint(placement.WorldToTexture, { position[0], position[1], position[2] })));
  uniforms.Direction.push_back(ToFloat(GetTravelDirection(light)));
}
}

//------------------------------------------------------------------------------
int CollectLights(vtkLightCollection* all, vtkVolumeProperty* property, int largestNumber,
  vtkLightCollection* collected)
{
  int left = 0;
  VisitLightsThatMatter(all, property,
    [&](vtkLight* light)
    {
      if (collected->GetNumberOfItems() < largestNumber)
      {
        collected->AddItem(light);
      }
      else
      {
        ++left;
      }
    });
  return left;
}

//------------------------------------------------------------------------------
LightUniforms MakeLightUniforms(vtkLightCollection* lights, vtkVolumeProperty* property,
  const VolumePlacement& placement, const Vector3& cameraDirection)
{
  LightUniforms uniforms;
  for (vtkLight* light : SortLights(lights, property))
  {
    if (GetLightKind(light) == LightKind::Directional)
    {
      AddDirectional(uniforms, placement,
        light->LightTypeIsHeadlight() ? cameraDirection : GetTravelDirection(light));
    }
    else
    {
      AddPositional(uniforms, placement, light);
    }
    const double intensity = light->GetIntensity();
    uniforms.Diffuse.push_back(
      Scaled(light->GetDiffuseColor(), intensity * property->GetDiffuse(0)));
    uniforms.Specular.push_back(
      Scaled(light->GetSpecularColor(), intensity * property->GetSpecular(0)));
    uniforms.Attenuation.push_back(Scaled(light->GetAttenuationValues(), 1.0));
    const double coneAngle = vtkMath::RadiansFromDegrees(light->GetConeAngle());
    uniforms.Cone.push_back(
      { static_cast<float>(std::cos(coneAngle)), static_cast<float>(light->GetExponent()) });
    uniforms.Shadow.push_back(GetShadow(light, placement));
  }
  return uniforms;
}

//------------------------------------------------------------------------------
bool ShadowCaster::operator==(const ShadowCaster& other) const
{
  return this->Place == other.Place && this->Begin == other.Begin && this->Enough == other.Enough &&
    this->Hard == other.Hard && this->FirstHit == other.FirstHit;
}

//------------------------------------------------------------------------------
std::vector<ShadowCaster> LightUniforms::GetShadowCasters(
  const LightingRequirements& requirements) const
{
  std::vector<ShadowCaster> casters;
  VisitShadowedLights(requirements,
    [&](int light, LightKind kind, ShadowKind shadow)
    {
      const Vector3f& place = this->Position[light];
      const float positional = kind == LightKind::Directional ? 0.0f : 1.0f;
      casters.push_back({ { place[0], place[1], place[2], positional }, this->Shadow[light][0],
        shadow == ShadowKind::Hard ? this->Shadow[light][1] : 0.0f, shadow == ShadowKind::Hard });
    });
  return casters;
}

//------------------------------------------------------------------------------
double LightUniforms::GetShadowedBrightness(const LightingRequirements& requirements) const
{
  double squares = 0.0;
  const auto brightest = [](const Vector3f& color)
  { return std::min(*std::max_element(color.begin(), color.end()), 1.0f); };
  VisitShadowedLights(requirements,
    [&](int light, LightKind, ShadowKind)
    {
      const double most =
        std::max(brightest(this->Diffuse[light]), brightest(this->Specular[light]));
      squares += most * most;
    });
  return std::sqrt(squares);
}

//------------------------------------------------------------------------------
void LightUniforms::LookUpVolume(
  const LightingRequirements& requirements, int casters, int blocks, double marchedLength)
{
  constexpr int castersPerBlock = 4;
  constexpr float wholeRay = 1e30f;
  this->ShadowComponent.assign(this->Position.size(), {});
  this->ShadowVolume.assign(this->Position.size(), {});
  int caster = 0;
  VisitShadowedLights(requirements,
    [&](int light, LightKind, ShadowKind)
    {
      if (caster >= casters)
      {
        this->ShadowVolume[light] = { 0.0f, wholeRay };
        return;
      }
      const float block = static_cast<float>(caster / castersPerBlock) / static_cast<float>(blocks);
      this->ShadowVolume[light] = { block, static_cast<float>(marchedLength) };
      this->ShadowComponent[light][caster % castersPerBlock] = 1.0f;
      ++caster;
    });
}

//------------------------------------------------------------------------------
void LightUniforms::LookUpMaps(const LightingRequirements& requirements,
  const std::vector<LightSpace>& spaces, double marchedLength)
{
  constexpr float wholeRay = 1e30f;
  this->MapAxes.assign(3 * this->Position.size(), {});
  this->Map.assign(this->Position.size(), {});
  std::size_t caster = 0;
  VisitShadowedLights(requirements,
    [&](int light, LightKind, ShadowKind)
    {
      if (caster >= spaces.size())
      {
        this->Map[light] = { -1.0f, wholeRay, 0.0f, 1.0f };
        return;
      }
      const LightSpace& space = spaces[caster];
      for (int axis = 0; axis < 3; ++axis)
      {
        for (int column = 0; column < 4; ++column)
        {
          this->MapAxes[3 * light + axis][column] =
            static_cast<float>(space.TextureToLight[4 * axis + column]);
        }
      }
      this->Map[light] = { static_cast<float>(caster), static_cast<float>(marchedLength),
        static_cast<float>(space.Projection), static_cast<float>(space.Extent) };
      ++caster;
    });
}

//------------------------------------------------------------------------------
void LightUniforms::LookUpLayers(const LightingRequirements& requirements,
  const std::vector<LightSpace>& spaces, const OpacityMapPlan& plan)
{
  this->Layers.assign(this->Position.size(), {});
  std::size_t caster = 0;
  VisitShadowedLights(requirements,
    [&](int light, LightKind, ShadowKind)
    {
      if (caster >= spaces.size())
      {
        return;
      }
      const LightSpace& space = spaces[caster];
      const double slices = plan.TextureSlices;
      const double first = (static_cast<double>(caster) * plan.Layers + 0.5) / slices;
      const double scale = 1.0 / (plan.GetSpacing(space) * slices);
      this->Layers[light] = { static_cast<float>(scale),
        static_cast<float>(first - space.Nearest * scale), static_cast<float>(first),
        static_cast<float>(first + (plan.Layers - 1.0) / slices) };
      ++caster;
    });
}

//------------------------------------------------------------------------------
void LightUniforms::SetAmbient(const std::array<double, 3>& ambient, double factor)
{
  this->Ambient = Scaled(ambient.data(), factor);
}

//------------------------------------------------------------------------------
int LightUniforms::GetLargestNumber(vtkOpenGLRenderWindow* window)
{
  // Arrays of vectors take four components an element; the scene's other uniforms take fewer than
  // 256.
  constexpr int componentsPerLight = 12 * 4;
  constexpr int otherComponents = 256;
  int components = 0;
  window->GetState()->vtkglGetIntegerv(GL_MAX_FRAGMENT_UNIFORM_COMPONENTS, &components);
  return std::max(components - otherComponents, 0) / componentsPerLight;
}

//------------------------------------------------------------------------------
void LightUniforms::Set(vtkShaderProgram* program) const
{
  const auto setVectors = [&](const char* name, const std::vector<Vector3f>& values)
  {
    if (!values.empty() && program->IsUniformUsed(name))
    {
      program->SetUniform3fv(name, static_cast<int>(values.size()), values.front().data());
    }
  };
  const auto setPairs = [&](const char* name, const std::vector<Vector2f>& values)
  {
    if (!values.empty() && program->IsUniformUsed(name))
    {
      program->SetUniform2fv(name, static_cast<int>(values.size()), values.front().data());
    }
  };
  const auto setQuadruples = [&](const char* name, const std::vector<Vector4f>& values)
  {
    if (!values.empty() && program->IsUniformUsed(name))
    {
      program->SetUniform4fv(name, static_cast<int>(values.size()), values.front().data());
    }
  };
  setVectors("scene_lightPosition", this->Position);
  setVectors("scene_lightDirection", this->Direction);
  setVectors("scene_lightDiffuse", this->Diffuse);
  setVectors("scene_lightSpecular", this->Specular);
  setVectors("scene_lightAttenuation", this->Attenuation);
  setPairs("scene_lightCone", this->Cone);
  setPairs("scene_lightShadow", this->Shadow);
  setPairs("scene_lightShadowVolume", this->ShadowVolume);
  setQuadruples("scene_lightShadowComponent", this->ShadowComponent);
  setQuadruples("scene_lightMapAxes", this->MapAxes);
  setQuadruples("scene_lightMap", this->Map);
  setQuadruples("scene_lightLayers", this->Layers);
  program->SetUniform3f("scene_ambient", this->Ambient.data());
}

}
