#include "Catch.h"
#include "EnvironmentSamples.h"

#include <vtkMath.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace penumbra;

namespace
{
constexpr double Powers[] = { 0.0, 1.0, 2.5, 30.0, 1000.0 };

/// In both forms, so fine that pixels as steps change no result.
std::vector<OwnedImages> MakeBothForms(const Environment& environment)
{
  return { MakeEquirectangular(1024, 512, environment), MakeCubeFaces(256, environment) };
}

double FindWorst(const CubeMap& cube, const Environment& expected)
{
  double worst = 0.0;
  for (const Direction& direction : SpreadDirections(500))
  {
    worst = std::max(worst, std::abs(Sample(cube, direction) - expected(direction)));
  }
  return worst;
}

/// The same ones on every machine.
class RandomValues
{
public:
  double Next()
  {
    this->State = this->State * 1664525u + 1013904223u;
    return (this->State >> 8) / 16777216.0;
  }

private:
  unsigned int State = 12345u;
};
}

TEST_CASE("A uniform environment stays exactly uniform")
{
  const float value = 0.3f;
  const Environment uniform = [=](const Direction&) { return value; };
  for (const OwnedImages& images :
    { MakeEquirectangular(50, 21, uniform), MakeCubeFaces(7, uniform) })
  {
    const EnvironmentMap map = images.MakeMap();
    CHECK(MeanRadiance(map)[1] == Approx(value).epsilon(1e-12));
    for (const double power : Powers)
    {
      for (const auto& face : FilterSpecular(map, power).Faces)
      {
        CHECK(std::count(face.begin(), face.end(), value) == static_cast<long>(face.size()));
      }
    }
  }
}

TEST_CASE("Where all the lobe sees is uniform, so is the result")
{
  const Environment white = [](const Direction& w) { return w[0] > 0.99 ? 1.0 : 0.5; };
  for (const OwnedImages& images : { MakeEquirectangular(64, 32, white), MakeCubeFaces(20, white) })
  {
    const CubeMap cube = FilterSpecular(images.MakeMap(), 100.0);
    const auto [least, greatest] = std::minmax_element(cube.Faces[1].begin(), cube.Faces[1].end());
    CHECK(*least == Approx(0.5).margin(1e-6));
    CHECK(*greatest == Approx(0.5).margin(1e-6));
  }
}

TEST_CASE("An environment that rises linearly is filtered to its closed form")
{
  const Direction D = Normalize({ 0.3, 0.5, -0.8 });
  const Environment linear = [&](const Direction& w) { return 0.5 + 0.5 * Dot(D, w); };
  for (const OwnedImages& images : MakeBothForms(linear))
  {
    const EnvironmentMap map = images.MakeMap();
    CHECK(MeanRadiance(map)[0] == Approx(0.5).margin(1e-5));
    CHECK(FindWorst(FilterDiffuse(map), [&](const Direction& N) { return 0.5 + Dot(D, N) / 3.0; }) <
      HalfStep);
    for (const double n : Powers)
    {
      CAPTURE(n);
      CHECK(FindWorst(FilterSpecular(map, n),
              [&](const Direction& R)
              { return 0.5 + 0.5 * Dot(D, R) * (n + 1.0) / (n + 2.0); }) < HalfStep);
    }
  }
}

TEST_CASE("A bright half of the sky is filtered to its closed form")
{
  const Environment sky = [](const Direction& w) { return w[1] > 0.0 ? 1.0 : 0.0; };
  for (const OwnedImages& images : MakeBothForms(sky))
  {
    const EnvironmentMap map = images.MakeMap();
    CHECK(FindWorst(FilterDiffuse(map), [](const Direction& N) { return 0.5 * (1.0 + N[1]); }) <
      HalfStep);
    CHECK(FindWorst(FilterSpecular(map, 0.0),
            [](const Direction& R) { return 1.0 - std::acos(R[1]) / vtkMath::Pi(); }) < HalfStep);
  }
}

TEST_CASE("A cosine's light on a diffuse surface is its closed form")
{
  const Direction D = Normalize({ -0.6, 0.2, 0.5 });
  const Environment cosine = [&](const Direction& w) { return std::max(Dot(D, w), 0.0); };
  const Environment expected = [&](const Direction& N)
  {
    const double angle = std::acos(std::clamp(Dot(D, N), -1.0, 1.0));
    return (std::sin(angle) + (vtkMath::Pi() - angle) * std::cos(angle)) * 2.0 /
      (3.0 * vtkMath::Pi());
  };
  for (const OwnedImages& images : MakeBothForms(cosine))
  {
    CHECK(FindWorst(FilterDiffuse(images.MakeMap()), expected) < HalfStep);
  }
}

TEST_CASE("Filtered maps are within half a step of the integral over pixels as they are")
{
  RandomValues random;
  const Environment blackOrWhite = [&](const Direction&)
  { return random.Next() < 0.5 ? 0.0 : 1.0; };
  for (const OwnedImages& images :
    { MakeEquirectangular(24, 13, blackOrWhite), MakeCubeFaces(5, blackOrWhite) })
  {
    const EnvironmentMap map = images.MakeMap();
    const Environment pixels = [&](const Direction& w) { return images.LookUp(w); };
    for (const double n : Powers)
    {
      const CubeMap cube = FilterSpecular(map, n);
      double worst = 0.0;
      for (const Direction& R : SpreadDirections(10))
      {
        const double integral = IntegrateLobe(pixels, R, n, 400);
        worst = std::max(worst, std::abs(Sample(cube, R) - integral));
      }
      CAPTURE(n, images.values[0].size(), worst * 255.0);
      CHECK(worst < HalfStep);
    }
  }
}

TEST_CASE("A sharp edge in the environment is blurred within half a step")
{
  const Environment sky = [](const Direction& w) { return w[1] > 0.0 ? 1.0 : 0.0; };
  const EnvironmentMap map = MakeEquirectangular(128, 64, sky).MakeMap();
  for (const double n : { 30.0, 1000.0 })
  {
    const CubeMap cube = FilterSpecular(map, n);
    double worst = 0.0;
    for (int i = 0; i < 60; ++i)
    {
      // Across the edge where faces have their largest texels.
      const double height = (i - 29.3) / 15.0 / std::sqrt(n + 1.0);
      const Direction R = Normalize({ 1.0, height, 0.01 * height });
      worst = std::max(worst, std::abs(Sample(cube, R) - IntegrateLobe(sky, R, n, 400)));
    }
    CAPTURE(n, worst * 255.0);
    CHECK(worst < HalfStep);
  }
}

TEST_CASE("A small bright spot lights nothing outside of its lobe, and nothing turns negative")
{
  const Direction D = Normalize({ 0.5, 0.7, -0.2 });
  const Environment sun = [&](const Direction& w) { return Dot(D, w) > 0.9999 ? 1e5 : 0.0; };
  const EnvironmentMap map = MakeEquirectangular(1024, 512, sun).MakeMap();
  for (const double n : { 1.0, 20.0, 1000.0 })
  {
    const CubeMap cube = FilterSpecular(map, n);
    const double peak = Sample(cube, D);
    CHECK(peak > 1.0);
    for (const Direction& R : SpreadDirections(500))
    {
      const double expected = peak * std::pow(std::max(Dot(D, R), 0.0), n);
      const double value = Sample(cube, R);
      CHECK(value >= 0.0);
      CHECK(value == Approx(expected).margin(0.01 * peak));
      if (Dot(D, R) < -0.1)
      {
        CHECK(value < 1e-3 * peak);
      }
    }
  }
}

TEST_CASE("Powers beyond the largest count as it, and none gives what is not finite")
{
  RandomValues random;
  const EnvironmentMap map =
    MakeEquirectangular(64, 32, [&](const Direction&) { return random.Next(); }).MakeMap();
  const CubeMap largest = FilterSpecular(map, LargestFilteredPower);
  CHECK(FilterSpecular(map, std::numeric_limits<double>::infinity()).Faces == largest.Faces);
  for (const auto& face : largest.Faces)
  {
    CHECK(std::all_of(face.begin(), face.end(), [](float value) { return value >= 0.0f; }));
  }
}

TEST_CASE("Filtered maps do not depend on the number of threads")
{
  RandomValues random;
  const EnvironmentMap map =
    MakeEquirectangular(64, 32, [&](const Direction&) { return random.Next(); }).MakeMap();
  for (const double power : { 1.0, 200.0 })
  {
    CubeMap together;
    CubeMap alone;
    vtkSMPTools::LocalScope(
      vtkSMPTools::Config{ 5, "STDThread", false }, [&] { together = FilterSpecular(map, power); });
    vtkSMPTools::LocalScope(
      vtkSMPTools::Config{ 1, "STDThread", false }, [&] { alone = FilterSpecular(map, power); });
    CHECK(alone.Faces == together.Faces);
  }
}
