#include "Catch.h"
#include "ReferenceScenes.h"

#include <vtkMath.h>

#include <cmath>

using namespace penumbra;

namespace
{
constexpr double Close = 2e-5;
constexpr double Pi = vtkMath::Pi();

/// Of the plane's specular term alone, one light from this direction, seen from that one; scaled so
/// that nothing is clamped.
class SpecularPlane
{
public:
  explicit SpecularPlane(int model)
    : Scene(MakePlaneScene())
    , Material(vtkVolumeMaterial::SafeDownCast(this->Scene.Property))
  {
    this->Material->SetReflectionModel(model);
    this->Material->SetDiffuse(0.0);
    this->Material->SetSpecular(1.0);
  }

  std::array<double, 4> Compute(const Point& toLight, const Point& toEye, double intensity = 0.01)
  {
    const auto light = MakeDirectionalLight({ -toLight[0], -toLight[1], -toLight[2] });
    light->SetIntensity(intensity);
    this->Scene.Lights = { light };
    this->Scene.Camera = MakeParallelCamera({ 0.0, 0.0, 5.0 }, { -toEye[0], -toEye[1], -toEye[2] });
    std::array<double, 4> color = ComputeMiddle(this->Scene, 1e-3).Color;
    for (double& value : color)
    {
      value /= intensity;
    }
    return color;
  }

  ReferenceScene Scene;
  vtkVolumeMaterial* Material;
};

const Point Up = { 0.0, 0.0, 1.0 };
/// Half of the way between up and this is 30 degrees off.
const Point Aside = { std::sin(Pi / 3.0), 0.0, std::cos(Pi / 3.0) };
}

TEST_CASE("Phong's lobe is about the mirrored light, Blinn's about the half way to it")
{
  SpecularPlane phong(vtkVolumeMaterial::Phong);
  phong.Material->SetSpecularPower(4.0);
  CHECK(phong.Compute(Aside, { -Aside[0], 0.0, Aside[2] })[0] == Approx(1.0).margin(Close));
  CHECK(phong.Compute(Aside, Up)[0] == Approx(std::pow(0.5, 4.0)).margin(Close));
  phong.Material->SetSpecularPower(0.0);
  CHECK(phong.Compute(Aside, Up)[0] == Approx(1.0).margin(Close));
  SpecularPlane blinn(vtkVolumeMaterial::BlinnPhong);
  blinn.Material->SetSpecularPower(4.0);
  CHECK(blinn.Compute(Aside, Up)[0] == Approx(std::pow(0.75, 2.0)).margin(Close));
}

TEST_CASE("Oren and Nayar's model is Lambert's where smooth, and theirs where rough")
{
  SpecularPlane plane(vtkVolumeMaterial::OrenNayar);
  plane.Material->SetDiffuse(1.0);
  plane.Material->SetRoughness(0.0);
  CHECK(plane.Compute(Aside, Aside)[0] == Approx(0.5).margin(Close));
  plane.Material->SetRoughness(0.5);
  const double a = 1.0 - 0.5 * 0.25 / 0.58;
  const double b = 0.45 * 0.25 / 0.34;
  const double rough = b * std::sin(Pi / 3.0) * std::tan(Pi / 3.0);
  CHECK(plane.Compute(Aside, Aside)[0] == Approx(0.5 * (a + rough)).margin(Close));
  CHECK(plane.Compute(Aside, { -Aside[0], 0.0, Aside[2] })[0] == Approx(0.5 * a).margin(Close));
}

TEST_CASE("Ward's models have his values")
{
  const double tangent = std::tan(Pi / 6.0);
  SpecularPlane ward(vtkVolumeMaterial::Ward);
  ward.Material->SetRoughness(0.4);
  CHECK(ward.Compute(Up, Up)[0] == Approx(1.0 / (4.0 * Pi * 0.16)).margin(Close));
  CHECK(ward.Compute(Aside, Up)[0] ==
    Approx(std::sqrt(0.5) * std::exp(-tangent * tangent / 0.16) / (4.0 * Pi * 0.16)).margin(Close));
  SpecularPlane brushed(vtkVolumeMaterial::WardAnisotropic);
  brushed.Material->SetRoughnessX(0.3);
  brushed.Material->SetRoughnessY(0.8);
  const auto expected = [&](double roughness)
  { return std::sqrt(0.5) * std::exp(-std::pow(tangent / roughness, 2.0)) / (4.0 * Pi * 0.24); };
  CHECK(brushed.Compute(Aside, Up)[0] == Approx(expected(0.3)).margin(Close));
  // The direction is one of the volume's: turned with it, or given across.
  brushed.Material->SetPreferredDirection(0.0, 3.0, 4.0);
  CHECK(brushed.Compute(Aside, Up)[0] == Approx(expected(0.8)).margin(Close));
}

TEST_CASE("Cook and Torrance's model has their values")
{
  SpecularPlane plane(vtkVolumeMaterial::CookTorrance);
  plane.Material->SetSlope(0.4);
  plane.Material->SetIndexOfRefraction(1.5, 1.0, 2.0);
  const auto color = plane.Compute(Up, Up);
  CHECK(color[0] == Approx(0.04 / (Pi * 0.16)).margin(Close));
  CHECK(color[1] == 0.0);
  CHECK(color[2] == Approx(1.0 / 9.0 / (Pi * 0.16)).margin(Close));
  const double cosine = std::cos(Pi / 6.0);
  const double g = std::sqrt(1.25 + cosine * cosine);
  const double fresnel = 0.5 * std::pow((g - cosine) / (g + cosine), 2.0) *
    (1.0 + std::pow((cosine * (g + cosine) - 1.0) / (cosine * (g - cosine) + 1.0), 2.0));
  const double facets = std::exp(-1.0 / 3.0 / 0.16) / (0.16 * std::pow(cosine, 4.0));
  // The eye at 60 degrees, the light above: masking is 2 N.H N.V / V.H = 1.
  CHECK(plane.Compute(Up, Aside)[0] == Approx(fresnel * facets / (Pi * 0.5)).margin(Close));
  const Point low = { std::sin(1.4), 0.0, std::cos(1.4) };
  plane.Material->SetIndexOfRefraction(0.3, 1.5, 1.5);
  plane.Material->SetDistributionToGaussian();
  plane.Material->SetGaussianConstant(2.0);
  const double gaussian = 2.0 * std::exp(-std::pow(0.7 / 0.4, 2.0));
  const double masking = 2.0 * std::cos(0.7) * std::cos(1.4) / std::cos(0.7);
  CHECK(plane.Compute(low, Up)[0] == Approx(gaussian * masking / Pi).margin(Close));
}

TEST_CASE("No model reflects on the side away from the light, or a highlight to beyond the surface")
{
  const int model = GENERATE(range(0, 6));
  SpecularPlane plane(model);
  CHECK(plane.Compute({ 0.6, 0.0, -0.8 }, Up)[0] == 0.0);
  // From within, at the volume's lower side: the surface itself is transparent from below.
  plane.Scene.TwoSidedLighting = true;
  CHECK(std::isfinite(plane.Compute({ 1.0, 0.0, 1e-9 }, { -1.0, 0.0, 1e-3 })[0]));
}
