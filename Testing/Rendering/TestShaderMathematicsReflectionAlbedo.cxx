#include "Catch.h"
#include "ModelAlbedo.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>

namespace
{
constexpr double Angles[] = { 0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 85.0 };
constexpr double Roughnesses[] = { 0.05, 0.1, 0.2, 0.4, 0.7, 1.0, 2.0 };
constexpr int Points = 8192;

// Of the sums over so many points; ModelAlbedo.h says what that of four times as many is.
constexpr double Tolerance = 1.5e-3;

double CosineOf(double degrees)
{
  return std::cos(vtkMath::RadiansFromDegrees(degrees));
}
}

TEST_CASE("Lambert's surface reflects all that it gets, whichever way it is seen")
{
  for (const double angle : Angles)
  {
    CHECK(OrenNayarAlbedo(0.0, angle, Points) == Approx(1.0).margin(1e-6));
  }
}

TEST_CASE("Oren and Nayar's surface reflects up to A + B / 2, at most 1.02 of what it gets")
{
  double most = 0.0;
  for (double roughness = 0.0; roughness < 3.0; roughness += 0.02)
  {
    const shader::vec4 parameters = OrenNayarParameters(roughness);
    double before = 0.0;
    for (const double angle : { 0.0, 45.0, 75.0, 85.0, 90.0 })
    {
      const double albedo = OrenNayarAlbedo(roughness, angle, Points);
      // It never falls towards grazing views. These functions are smooth: 1e-5 is their error.
      CHECK(albedo >= before - 1e-5);
      before = albedo;
    }
    CHECK(before == Approx(parameters.x + 0.5 * parameters.y).margin(1e-4));
    CHECK((before > 1.0 + 1e-4) == (roughness > 0.01 && roughness < 0.326));
    most = std::max(most, before);
  }
  CHECK(most == Approx(1.0152).margin(1e-4));
}

TEST_CASE(
  "Ward's lobe reflects at most what it gets for views up to 85 degrees, N.V of it if narrow")
{
  for (const double angle : Angles)
  {
    for (const double x : Roughnesses)
    {
      for (const double y : Roughnesses)
      {
        CHECK(WardAlbedoAcross(x, y, angle, Points) <= 1.0 + Tolerance);
        CHECK(WardAlbedoAlong(x, y, angle, Points) <= 1.0 + Tolerance);
      }
    }
    // Half vectors near the normal only: to first order in the variance, which N.V divides.
    CHECK(WardAlbedo(0.01, angle, Points) == Approx(CosineOf(angle)).margin(1e-3));
  }
}

TEST_CASE("Ward's lobe reflects little at 85 degrees, and more than it gets only beyond 89.3")
{
  for (const double x : Roughnesses)
  {
    CHECK(WardAlbedo(x, 85.0, Points) < 0.30);
    CHECK(WardAlbedo(x, 89.7, Points) < 1.0);
    for (const double y : Roughnesses)
    {
      CHECK(WardAlbedoAcross(x, y, 85.0, Points) < 0.42);
      CHECK(WardAlbedoAcross(x, y, 89.3, Points) < 1.0);
    }
  }
  // The roughnesses that reflect most there.
  CHECK(WardAlbedo(0.75, 89.8, Points) > 1.1);
  CHECK(WardAlbedoAcross(0.03, 1.0, 89.5, Points) > 1.0);
  // It grows as 1 / sqrt(N.V), but for what changes besides so near.
  CHECK(WardAlbedo(0.75, 89.99, Points) / WardAlbedo(0.75, 89.9, Points) ==
    Approx(std::sqrt(10.0)).epsilon(0.01));
}

TEST_CASE("Cook and Torrance's mirroring facets reflect up to four times what they get")
{
  for (const double angle : Angles)
  {
    for (const double slope : Roughnesses)
    {
      CHECK(BeckmannAlbedo(slope, 0.0, angle, Points) <= 4.0 * (1.0 + Tolerance));
    }
  }
  CHECK(BeckmannAlbedo(0.05, 0.0, 0.0, Points) == Approx(4.0).epsilon(Tolerance));
}

TEST_CASE(
  "Cook and Torrance's glass reflects four times Fresnel's share straight on, and more than "
  "it gets beyond 75 degrees")
{
  CHECK(BeckmannAlbedo(0.05, 1.5, 0.0, Points) == Approx(4.0 * 0.04).margin(Tolerance));
  for (const double slope : Roughnesses)
  {
    CHECK(BeckmannAlbedo(slope, 1.5, 74.0, Points) < 1.0);
    CHECK(BeckmannAlbedo(slope, 1.5, 85.0, Points) < vtkMath::Pi());
  }
  CHECK(BeckmannAlbedo(0.05, 1.5, 76.0, Points) > 1.0);
  CHECK(BeckmannAlbedo(0.3, 1.5, 82.0, Points) < 1.0);
  CHECK(BeckmannAlbedo(0.3, 1.5, 83.0, Points) > 1.0);
  CHECK(BeckmannAlbedo(0.6, 1.5, 86.0, Points) < 1.0);
  CHECK(BeckmannAlbedo(0.6, 1.5, 88.0, Points) > 1.0);
  CHECK(BeckmannAlbedo(0.05, 1.5, 85.0, Points) == Approx(2.13).margin(0.01));
}

TEST_CASE("Phong's highlight reflects 2 / (n + 1) straight on and half of that along the surface")
{
  for (const double power : { 0.0, 1.0, 10.0, 100.0, 1000.0 })
  {
    const double straight = 2.0 / (power + 1.0);
    CHECK(PhongAlbedo(power, 0.0, Points) == Approx(straight).epsilon(Tolerance));
    CHECK(PhongAlbedo(power, 90.0, Points) == Approx(0.5 * straight).epsilon(Tolerance));
    for (const double angle : Angles)
    {
      CHECK(PhongAlbedo(power, angle, Points) <= straight * (1.0 + Tolerance));
    }
  }
}

TEST_CASE("Blinn and Phong's highlight reflects 8 / (n + 2) straight on, less the horizon's part")
{
  for (const double power : { 0.5, 1.0, 5.3, 10.0, 1000.0 })
  {
    CHECK(BlinnPhongAlbedo(power, 0.0) ==
      Approx(8.0 / (power + 2.0) * (1.0 - std::pow(2.0, -0.5 * power - 1.0))).epsilon(Tolerance));
  }
  CHECK(BlinnPhongAlbedo(5.3, 0.0) > 1.0);
  CHECK(BlinnPhongAlbedo(5.5, 0.0) < 1.0);
  for (const double angle : { 0.0, 30.0, 60.0 })
  {
    // The corrections are of the order 1 / n, over the square of N.V.
    CHECK(BlinnPhongAlbedo(1000.0, angle, Points) * 1002.0 / 8.0 ==
      Approx(CosineOf(angle)).margin(4e-3));
  }
}
