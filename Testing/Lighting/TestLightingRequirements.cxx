#include "Catch.h"
#include "LightsAndMaterial.h"
#include "MakeLight.h"

#include <vtkPiecewiseFunction.h>

#include <functional>
#include <vector>

using namespace penumbra;

namespace
{
using Change = std::function<void(LightingRequirements&)>;

// Each makes another value of its field.
const std::vector<Change> changes = {
  [](LightingRequirements& r) { r.Optics = OpticalModel::Emission; },
  [](LightingRequirements& r) { r.Lights[2][1] = 3; },
  [](LightingRequirements& r) { r.Technique = static_cast<ShadowTechnique>(7); },
  [](LightingRequirements& r) { r.NearShadowRays = true; },
  [](LightingRequirements& r) { r.NearShadowSteps = 3; },
  [](LightingRequirements& r) { r.Reflection = static_cast<ReflectionModel>(7); },
  [](LightingRequirements& r) { r.Gradient = static_cast<GradientEstimator>(7); },
  [](LightingRequirements& r) { r.GradientTexture = true; },
  [](LightingRequirements& r) { r.NoiseFading = true; },
  [](LightingRequirements& r) { r.Diffuse = true; },
  [](LightingRequirements& r) { r.Specular = true; },
  [](LightingRequirements& r) { r.TwoSidedLighting = true; },
  [](LightingRequirements& r) { r.Attenuation = true; },
  [](LightingRequirements& r) { r.GradientOpacity = true; },
  [](LightingRequirements& r) { r.ClippingPlanes = 2; },
  [](LightingRequirements& r) { r.Cropping = CroppingKind::Box; },
  [](LightingRequirements& r) { r.Mask = true; },
  [](LightingRequirements& r) { r.Opacity = TransferFunctionLookup::Points; },
  [](LightingRequirements& r) { r.PreIntegrated = true; },
  [](LightingRequirements& r) { r.HalvedSteps = true; },
  [](LightingRequirements& r) { r.EmptySpaceSkipping = true; },
  [](LightingRequirements& r) { r.Counting = true; },
};

vtkSmartPointer<vtkPiecewiseFunction> MakeGradientOpacity()
{
  auto function = vtkSmartPointer<vtkPiecewiseFunction>::New();
  function->AddPoint(0.0, 0.0);
  function->AddPoint(10.0, 1.0);
  return function;
}
}

TEST_CASE("Requirements are equal when every field is, and differ when any does")
{
  // A new field does not compile here, so that it cannot be forgotten above.
  const LightingRequirements base;
  const auto& [optics, lights, technique, near, nearSteps, reflection, gradient, gradientTexture,
    fading, diffuse, specular, sides, attenuation, gradientOpacity, planes, cropping, mask, opacity,
    preIntegrated, halvedSteps, emptySpace, counting] = base;
  CHECK_FALSE((diffuse || specular || sides || attenuation || gradientOpacity || mask));
  CHECK_FALSE((gradientTexture || fading || preIntegrated || emptySpace || near || nearSteps > 0));
  CHECK_FALSE((counting || halvedSteps));
  CHECK(optics == OpticalModel::AbsorptionEmission);
  CHECK(
    (planes == 0 && cropping == CroppingKind::None && opacity == TransferFunctionLookup::Table));
  CHECK((lights == decltype(base.Lights){} && static_cast<int>(technique) == 0 &&
    static_cast<int>(reflection) == 0 && static_cast<int>(gradient) == 0));
  CHECK(changes.size() == 22);

  for (const Change& change : changes)
  {
    LightingRequirements changed;
    change(changed);
    LightingRequirements again;
    change(again);
    CHECK(changed != base);
    CHECK_FALSE(changed == base);
    CHECK(changed == again);
    CHECK_FALSE(changed != again);
  }
}

TEST_CASE("Each field of the scene changes exactly its own requirement")
{
  const auto light = MakeLight(LightKind::Point, ShadowKind::Soft);
  LightsAndMaterial with({ light });
  with.scene.TwoSidedLighting = false;
  LightingRequirements expected = with.Requirements();
  REQUIRE(expected.IsShaded());

  with.scene.TwoSidedLighting = expected.TwoSidedLighting = true;
  CHECK(with.Requirements() == expected);
  with.scene.ClippingPlanes = expected.ClippingPlanes = 6;
  CHECK(with.Requirements() == expected);
  with.scene.Cropping = expected.Cropping = CroppingKind::Regions;
  CHECK(with.Requirements() == expected);
  with.scene.Mask = expected.Mask = true;
  CHECK(with.Requirements() == expected);
  with.scene.Opacity = expected.Opacity = TransferFunctionLookup::Points;
  CHECK(with.Requirements() == expected);
  with.scene.Gradient = expected.Gradient = GradientEstimator::Sobel;
  CHECK(with.Requirements() == expected);
  with.scene.GradientTexture = expected.GradientTexture = true;
  CHECK(with.Requirements() == expected);
  with.scene.EmptySpace = expected.EmptySpaceSkipping = true;
  CHECK(with.Requirements() == expected);
  with.property->SetGradientOpacity(MakeGradientOpacity());
  expected.GradientOpacity = true;
  CHECK(with.Requirements() == expected);
  with.property->DisableGradientOpacityOn();
  expected.GradientOpacity = false;
  CHECK(with.Requirements() == expected);
  with.property->SetSpecular(0.0);
  expected.Specular = false;
  CHECK(with.Requirements() == expected);
  with.property->SetSpecular(0.2);
  with.property->SetDiffuse(0.0);
  expected.Specular = true;
  expected.Diffuse = false;
  CHECK(with.Requirements() == expected);
}

TEST_CASE("Without shading no light, side or material matters, but what hides matter does")
{
  const auto light = MakeLight(LightKind::Spot, ShadowKind::Hard);
  light->SetAttenuationValues(1.0, 0.5, 0.0);
  LightsAndMaterial with({ light });
  with.property->ShadeOff();
  with.property->SetGradientOpacity(MakeGradientOpacity());
  with.scene.ClippingPlanes = 1;
  with.scene.Cropping = CroppingKind::Box;
  with.scene.Mask = true;
  LightingRequirements expected;
  expected.GradientOpacity = true;
  expected.ClippingPlanes = 1;
  expected.Cropping = CroppingKind::Box;
  expected.Mask = true;
  CHECK(with.Requirements() == expected);
  CHECK(expected.NeedsGradient());
  CHECK_FALSE(expected.NeedsNormal());
}

TEST_CASE("No lights at all is a scene of ambient light only")
{
  LightsAndMaterial with;
  LightingRequirements expected;
  expected.Optics = OpticalModel::SingleScattering;
  CHECK(with.Requirements() == expected);
  with.scene.Lights = nullptr;
  CHECK(with.Requirements() == expected);
}

TEST_CASE("Steep functions are pre-integrated, where steps have a scalar at each end")
{
  LightsAndMaterial with;
  CHECK_FALSE(with.Requirements().PreIntegrated);
  with.scene.SteepOpacity = with.scene.LinearInterpolation = true;
  CHECK(with.Requirements().PreIntegrated);
  with.scene.Cropping = CroppingKind::Box;
  CHECK(with.Requirements().PreIntegrated);
  with.scene.Cropping = CroppingKind::Regions;
  CHECK_FALSE(with.Requirements().PreIntegrated);
  with.scene.Cropping = CroppingKind::None;
  with.scene.Mask = true;
  CHECK_FALSE(with.Requirements().PreIntegrated);
  with.scene.Mask = false;
  with.scene.Opacity = TransferFunctionLookup::Points;
  CHECK(with.Requirements().PreIntegrated);
  CHECK(with.Requirements().Opacity == TransferFunctionLookup::Table);
  with.scene.LinearInterpolation = false;
  CHECK_FALSE(with.Requirements().PreIntegrated);
}
