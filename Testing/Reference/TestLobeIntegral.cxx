#include "Catch.h"
#include "LobeTable.h"

#include <vtkMath.h>
#include <vtkVectorOperators.h>

#include <cmath>
#include <functional>

using namespace penumbra;
using namespace penumbra::reference;

namespace
{
using Sky = std::function<double(const vtkVector3d&)>;

EnvironmentImage MakeImage(int width, int height, const Sky& sky,
  const std::function<vtkVector3d(double, double)>& getDirection)
{
  EnvironmentImage image{ width, height, {} };
  for (int row = 0; row < height; ++row)
  {
    for (int column = 0; column < width; ++column)
    {
      const double value = sky(getDirection((column + 0.5) / width, (row + 0.5) / height));
      image.Pixels.insert(image.Pixels.end(), 3, static_cast<float>(value));
    }
  }
  return image;
}

EnvironmentMap MakeEquirectangular(int width, int height, const Sky& sky)
{
  const double pi = vtkMath::Pi();
  return { { MakeImage(width, height, sky,
    [pi](double s, double t)
    {
      const double azimuth = (2.0 * s - 1.0) * pi;
      return vtkVector3d(std::sin(t * pi) * std::cos(azimuth), std::cos(t * pi),
        std::sin(t * pi) * std::sin(azimuth));
    }) } };
}

/// By the rows and columns of OpenGL's table.
EnvironmentMap MakeCube(int size, const Sky& sky)
{
  EnvironmentMap map;
  for (int face = 0; face < 6; ++face)
  {
    map.Images.push_back(MakeImage(size, size, sky,
      [face](double s, double t)
      {
        const double a = 2.0 * s - 1.0;
        const double b = 2.0 * t - 1.0;
        const vtkVector3d directions[] = { { 1.0, -b, -a }, { -1.0, -b, a }, { a, 1.0, b },
          { a, -1.0, -b }, { a, -b, 1.0 }, { -a, -b, -1.0 } };
        return directions[face].Normalized();
      }));
  }
  return map;
}

const vtkVector3d Directions[] = { { 0.0, 1.0, 0.0 }, { -1.0, 0.0, 0.0 },
  vtkVector3d(0.3, -0.2, 0.9).Normalized(), vtkVector3d(-0.7, 0.4, -0.5).Normalized(),
  vtkVector3d(-1.0, 0.01, -0.003).Normalized() };

/// Checks both forms of the map.
void CheckLobe(const Sky& sky, double power, const Sky& expected, double margin)
{
  for (const EnvironmentMap& map : { MakeEquirectangular(500, 250, sky), MakeCube(120, sky) })
  {
    const Surroundings surroundings(map, LobeIntegral::GetLargestPixel(power));
    const LobeIntegral lobe(surroundings, power);
    for (const vtkVector3d& direction : Directions)
    {
      CAPTURE(power, map.Images.size(), direction[0], direction[1], direction[2]);
      CHECK(lobe.Evaluate(direction)[1] == Approx(expected(direction)).margin(margin));
    }
  }
}
}

TEST_CASE("Uniform surroundings look uniform through any lobe")
{
  const double power = GENERATE(0.0, 0.5, 1.0, 2.0, 20.0, 300.0, 1e5);
  const Sky grey = [](const vtkVector3d&) { return 0.5; };
  for (const EnvironmentMap& map : { MakeEquirectangular(30, 13, grey), MakeCube(7, grey) })
  {
    const Surroundings surroundings(map, LobeIntegral::GetLargestPixel(power));
    CHECK(surroundings.GetMean()[0] == Approx(0.5).epsilon(1e-6));
    const LobeIntegral lobe(surroundings, power);
    for (const vtkVector3d& direction : Directions)
    {
      CHECK(lobe.Evaluate(direction)[2] == Approx(0.5).margin(0.5 * lobe.GetError()));
    }
  }
}

TEST_CASE("Surroundings that rise linearly are seen by their closed form")
{
  const double power = GENERATE(0.0, 1.0, 2.5, 30.0, 1000.0);
  const vtkVector3d up = vtkVector3d(0.3, 0.5, -0.8).Normalized();
  // Pixels as steps are off by 1e-5 or so.
  CheckLobe([&](const vtkVector3d& w) { return 0.5 + 0.5 * up.Dot(w); }, power,
    [&](const vtkVector3d& R) { return 0.5 + 0.5 * up.Dot(R) * (power + 1.0) / (power + 2.0); },
    2e-4);
}

TEST_CASE("A bright half of the sky is seen by its closed form")
{
  const Sky sky = [](const vtkVector3d& w) { return w[1] > 0.0 ? 1.0 : 0.0; };
  CheckLobe(
    sky, 1.0, [](const vtkVector3d& N) { return 0.5 * (1.0 + N[1]); }, 4e-5);
  CheckLobe(
    sky, 0.0, [](const vtkVector3d& R) { return 1.0 - std::acos(R[1]) / vtkMath::Pi(); }, 3e-4);
}

TEST_CASE("The table is within its bound of the integral")
{
  const double power = GENERATE(1.0, 8.0, 40.0);
  const Sky spots = [](const vtkVector3d& w)
  { return std::sin(9.0 * w[0]) * std::cos(7.0 * w[1]) > 0.3 ? 1.0 : 0.1; };
  const Surroundings surroundings(
    MakeEquirectangular(64, 32, spots), LobeIntegral::GetLargestPixel(power));
  const LobeIntegral lobe(surroundings, power);
  const LobeTable table(lobe, 1e-5);
  for (const vtkVector3d& direction : Directions)
  {
    const LobeTable::Result result = table.LookUp(direction);
    CHECK(result.Error <= 1.01 * lobe.GetError());
    CHECK(result.Value[0] == Approx(lobe.Evaluate(direction)[0]).margin(result.Error));
  }
}
