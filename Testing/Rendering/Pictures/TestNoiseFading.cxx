#include "Catch.h"
#include "ImageComparison.h"
#include "ReflectingScene.h"
#include "SyntheticVolumes.h"

#include <vtkPiecewiseFunction.h>

#include <cmath>
#include <random>

using namespace penumbra;

namespace
{
constexpr double Diffuse = 0.6;
constexpr double Gray = 0.9;

// A box of one value and white noise, opaque, lit from the front, with F_d = N.L alone.
std::unique_ptr<IlluminatedScene> MakeNoisyBox(double noise, double fading)
{
  std::mt19937 generator(5);
  std::normal_distribution<double> normal(0.0, 1.0);
  VolumeGrid grid;
  grid.scalarType = VTK_FLOAT;
  const auto volume = SampleField(
    grid, [&](const Point&) { return 100.0 + (noise > 0.0 ? noise * normal(generator) : 0.0); });
  auto scene = MakeReflectingScene(
    [=](vtkVolumeMaterial* material)
    {
      material->SetAmbient(0.0);
      material->SetDiffuse(Diffuse);
      material->SetSpecular(0.5);
      material->SetNoiseFading(fading);
    });
  scene->Mapper->SetInputData(volume);
  scene->Opacity->RemoveAllPoints();
  scene->Opacity->AddPoint(0.0, 0.9999);
  scene->Color->RemoveAllPoints();
  scene->Color->AddRGBPoint(0.0, Gray, Gray, Gray);
  scene->GetLight()->SetShadowToNone();
  const double center[3] = { 15.5, 15.5, 15.5 };
  scene->LookFrom(0.0, 0.0, 1.0, 60.0, center);
  return scene;
}

struct Statistics
{
  double mean = 0.0;
  double deviation = 0.0;
};

Statistics MiddleOf(vtkImageData* picture)
{
  Statistics statistics;
  constexpr int first = 48;
  constexpr int count = 32 * 32;
  double squares = 0.0;
  for (int at = 0; at < count; ++at)
  {
    const double level =
      picture->GetScalarComponentAsDouble(first + at % 32, first + at / 32, 0, 0) / 255.0;
    statistics.mean += level / count;
    squares += level * level / count;
  }
  statistics.deviation = std::sqrt(std::max(squares - statistics.mean * statistics.mean, 0.0));
  return statistics;
}

// Half a grey level.
constexpr double Rounding = 0.5 / 255.0;
}

TEST_CASE("Without a gradient a faded reflection is the mean over all normals")
{
  const auto scene = MakeNoisyBox(0.0, 2.0);
  CHECK(MiddleOf(scene->Render()).mean == Approx(Gray * Diffuse * 0.5).margin(Rounding));
  scene->Renderer->TwoSidedLightingOff();
  CHECK(MiddleOf(scene->Render()).mean == Approx(Gray * Diffuse * 0.25).margin(Rounding));
  GetMaterial(*scene)->SetNoiseFading(0.0);
  CHECK(MiddleOf(scene->Render()).mean == 0.0);
}

TEST_CASE("Fading calms a surface of noise, and does not darken it")
{
  const auto sparkling = MiddleOf(MakeNoisyBox(5.0, 0.0)->Render());
  const auto calm = MiddleOf(MakeNoisyBox(5.0, 3.0)->Render());
  REQUIRE(sparkling.deviation > 0.1);
  // At 3 times the noise a typical sample keeps 1 - exp(-1/9), a tenth of its direction.
  CHECK(calm.deviation < 0.25 * sparkling.deviation);
  CHECK(calm.mean == Approx(Gray * Diffuse * 0.5).margin(0.03));
}

TEST_CASE("Clean data is shaded as without fading")
{
  // Steep everywhere but for the very middle.
  VolumeGrid grid;
  grid.scalarType = VTK_FLOAT;
  const auto cone = SampleField(grid,
    [](const Point& p) { return 255.0 - 8.0 * std::hypot(p[0] - 15.5, p[1] - 15.5, p[2] - 15.5); });
  const auto render = [&](double fading)
  {
    auto scene =
      MakeReflectingScene([=](vtkVolumeMaterial* material) { material->SetNoiseFading(fading); });
    scene->Mapper->SetInputData(cone);
    return scene->Render();
  };
  CHECK(CompareImages(render(1.0), render(0.0)).rmse < 0.05);
}
