#include "Illumination.h"

#include "LevelCrossings.h"
#include "LightVisibility.h"
#include "ReferenceScene.h"
#include "ScalarNoise.h"

#include "vtkVectorOperators.h"
#include "vtkVolumeMaterial.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace penumbra::reference
{
namespace
{
const std::vector<double> Zero = { 0.0 };

/// F_d of normals of all directions.
constexpr double DiffuseOfAllNormals = 0.25;

/// gradient . direction(u), a sign change of which turns a surface's side.
void AppendTurns(const SpanGradient& gradient, const vtkVector3d& direction,
  const vtkVector3d& change, std::vector<double>& breaks)
{
  Polynomial<4> product;
  for (int axis = 0; axis < 3; ++axis)
  {
    Add(product, Product(gradient[axis], Polynomial<1>{ { direction[axis], change[axis] } }));
  }
  AppendCrossings(product, Zero, breaks);
}

/// Where the path start + u step passes the cone's surface (or its mirror image behind the light).
void AppendConeBorder(const LightSource& light, const vtkVector3d& start, const vtkVector3d& step,
  std::vector<double>& breaks)
{
  const vtkVector3d offset = start - light.Position;
  const Polynomial<1> along{ { offset.Dot(light.Axis), step.Dot(light.Axis) } };
  Polynomial<2> difference = Product(along, along);
  const double squared = light.CosineOfCone * light.CosineOfCone;
  Add(difference,
    Polynomial<2>{ { -squared * offset.SquaredNorm(), -2.0 * squared * offset.Dot(step),
      -squared * step.SquaredNorm() } });
  AppendCrossings(difference, Zero, breaks);
}
}

//------------------------------------------------------------------------------
Illumination::Illumination(
  const ReferenceScene& scene, const VolumeMatter& matter, double tolerance)
  : Matter(matter)
  , Tolerance(tolerance)
  , TwoSided(scene.TwoSidedLighting)
  , Ambient(scene.Property->GetAmbient())
  , Diffuse(scene.Property->GetDiffuse())
  , Specular(scene.Property->GetSpecular())
  , AmbientLight(GetAmbientLight(scene))
  , Formula(scene.Property)
{
  if (this->Formula.GetModel() == ReflectionModel::ReflectionMap)
  {
    this->Environment.emplace(vtkVolumeMaterial::SafeDownCast(scene.Property), tolerance);
  }
  else
  {
    this->Lights = MakeLightSources(scene, matter.GetFrame().GetSmallestSpacing());
  }
  for (LightSource& light : this->Lights)
  {
    light.HardShadow = light.Shadow == ShadowKind::Hard ? this->HardShadows++ : -1;
  }
  if (auto* material = vtkVolumeMaterial::SafeDownCast(scene.Property))
  {
    const vtkVector3d preferred(material->GetPreferredDirection());
    this->Preferred = matter.GetFrame().OwnToWorld(preferred).Normalized();
    if (material->GetNoiseFading() > 0.0)
    {
      this->FadingGradient = material->GetNoiseFading() *
        GetGradientNoise(matter.GetField(), matter.GetFrame().GetSpacing(), scene.Gradient);
    }
  }
}

//------------------------------------------------------------------------------
std::string Illumination::GetEnvironmentFault() const
{
  return this->Environment ? this->Environment->GetFault() : std::string();
}

//------------------------------------------------------------------------------
void Illumination::AppendBreaks(const CellSpan& span, const SpanGradient& gradient,
  const vtkVector3d& toEye, std::vector<double>& breaks) const
{
  const VolumeFrame& frame = this->Matter.GetFrame();
  const vtkVector3d none(0.0);
  const vtkVector3d start = span.Start + vtkVector3d(span.Cell[0], span.Cell[1], span.Cell[2]);
  for (const LightSource& light : this->Lights)
  {
    if (light.HasPosition)
    {
      AppendTurns(gradient, frame.ToIndex(light.Position) - start, -span.Step, breaks);
    }
    else
    {
      AppendTurns(gradient, frame.DirectionToIndex(light.Axis), none, breaks);
    }
    if (light.HasCone)
    {
      const vtkVector3d worldStart = frame.ToWorld(start);
      AppendConeBorder(light, worldStart, frame.ToWorld(start + span.Step) - worldStart, breaks);
    }
  }
  if (this->Formula.DependsOnSideOfEye())
  {
    AppendTurns(gradient, toEye, none, breaks);
  }
}

//------------------------------------------------------------------------------
ShadedSample Illumination::Shade(const MatterSample& sample) const
{
  ShadedSample shaded;
  shaded.ShadowMargins.assign(this->HardShadows, std::numeric_limits<double>::quiet_NaN());
  for (int channel = 0; channel < 3; ++channel)
  {
    shaded.Color[channel] = sample.Color[channel] * this->Ambient * this->AmbientLight[channel];
  }
  const vtkVector3d gradient = this->Matter.GetFrame().GradientToWorld(sample.Gradient);
  const double magnitude = gradient.Norm();
  const double directional = this->GetDirectionalShare(sample.Gradient);
  if (magnitude > 0.0 || directional < 1.0)
  {
    const vtkVector3d normal = magnitude > 0.0 ? gradient * (-1.0 / magnitude) : vtkVector3d(0.0);
    if (this->Environment)
    {
      this->AddEnvironment(sample, normal, directional, shaded);
    }
    this->AddLights(sample, normal, directional, shaded);
  }
  for (double& value : shaded.Color)
  {
    value = std::clamp(value, 0.0, 1.0);
  }
  return shaded;
}

//------------------------------------------------------------------------------
double Illumination::GetDirectionalShare(const vtkVector3d& gradient) const
{
  if (this->FadingGradient == 0.0)
  {
    return 1.0;
  }
  const double magnitude = this->Matter.GetFrame().GradientToOwn(gradient).Norm();
  const double ratio = magnitude / this->FadingGradient;
  return -std::expm1(-ratio * ratio);
}

//------------------------------------------------------------------------------
void Illumination::AddEnvironment(const MatterSample& sample, const vtkVector3d& normal,
  double directional, ShadedSample& shaded) const
{
  const vtkVector3d mirrored = normal * (2.0 * normal.Dot(sample.ToEye)) - sample.ToEye;
  const auto diffuse = this->Environment->GetDiffuse(normal);
  const auto specular = this->Environment->GetSpecular(mirrored);
  const Rgb& mean = this->Environment->GetMean();
  for (int channel = 0; channel < 3; ++channel)
  {
    const double faded = directional * diffuse.Value[channel] + (1.0 - directional) * mean[channel];
    shaded.Color[channel] += sample.Color[channel] * this->Diffuse * faded +
      this->Specular * directional * specular.Value[channel];
  }
  shaded.Error += this->Diffuse * diffuse.Error + this->Specular * specular.Error;
}

//------------------------------------------------------------------------------
void Illumination::AddLights(const MatterSample& sample, const vtkVector3d& normal,
  double directional, ShadedSample& shaded) const
{
  for (const LightSource& light : this->Lights)
  {
    this->AddLight(light, sample, normal, directional, shaded);
  }
}

//------------------------------------------------------------------------------
void Illumination::AddLight(const LightSource& light, const MatterSample& sample,
  const vtkVector3d& normal, double directional, ShadedSample& shaded) const
{
  vtkVector3d toLight = -light.Axis;
  double falloff = 1.0;
  if (light.HasPosition)
  {
    toLight = light.Position - this->Matter.GetFrame().ToWorld(sample.Position);
    const double distance = toLight.Norm();
    toLight = distance > 0.0 ? toLight * (1.0 / distance) : vtkVector3d(0.0);
    falloff = light.GetAttenuation(distance) * light.GetSpot(-toLight);
  }
  if (toLight.SquaredNorm() == 0.0 || falloff == 0.0)
  {
    return;
  }
  Rgb reflected = this->Reflect(light, sample, normal, toLight, directional);
  const double most = falloff * *std::max_element(reflected.begin(), reflected.end());
  if (most <= 0.0)
  {
    return;
  }
  Visibility visibility;
  if (light.Shadow != ShadowKind::None)
  {
    const double tolerance = this->Tolerance / most / static_cast<double>(this->Lights.size());
    visibility = GetVisibility(this->Matter, light, sample.Position, toLight, tolerance);
    ++shaded.ShadowRays;
  }
  if (light.HardShadow >= 0)
  {
    shaded.ShadowMargins[light.HardShadow] = visibility.Margin;
  }
  for (int channel = 0; channel < 3; ++channel)
  {
    shaded.Color[channel] += falloff * visibility.Share * reflected[channel];
  }
  shaded.Error += most * visibility.Error;
}

//------------------------------------------------------------------------------
Rgb Illumination::Reflect(const LightSource& light, const MatterSample& sample, vtkVector3d normal,
  const vtkVector3d& toLight, double directional) const
{
  if (this->TwoSided && normal.Dot(toLight) < 0.0)
  {
    normal = -normal;
  }
  const Reflected reflected =
    this->Formula.Evaluate({ normal, toLight, sample.ToEye, this->Preferred });
  const double ofAllNormals = (this->TwoSided ? 2.0 : 1.0) * DiffuseOfAllNormals;
  const double diffuse = directional * reflected.Diffuse + (1.0 - directional) * ofAllNormals;
  Rgb sum;
  for (int channel = 0; channel < 3; ++channel)
  {
    sum[channel] = sample.Color[channel] * this->Diffuse * light.Diffuse[channel] * diffuse +
      this->Specular * light.Specular[channel] * directional * reflected.Specular[channel];
  }
  return sum;
}

}
