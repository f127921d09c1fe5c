#include "Catch.h"
#include "ShadowChoice.h"

#include <cmath>
#include <random>
#include <set>

using namespace penumbra;

namespace
{
constexpr ShadowOption Options[] = { ShadowOption::Rays, ShadowOption::CoarseVolume,
  ShadowOption::MediumVolume, ShadowOption::DeepMap, ShadowOption::MarchedVolume,
  ShadowOption::MarchedDeepMap, ShadowOption::OpacityMap, ShadowOption::MarchedOpacityMap,
  ShadowOption::FineOpacityMap, ShadowOption::FinestOpacityMap, ShadowOption::Volume,
  ShadowOption::OneStepOpacityMap, ShadowOption::UnmarchedFineOpacityMap,
  ShadowOption::OneStepVolume };

// A bone-like volume of 256^3 on 512 x 512 pixels, a tenth of it occupied.
ShadowChoiceTask MakeTask()
{
  ShadowChoiceTask task;
  task.SoftLights = 1;
  task.VoxelDepth = 1.0;
  task.Pixels = 512.0 * 512.0;
  task.VoxelsAcross = 443.0;
  task.Voxels = 256.0 * 256.0 * 256.0;
  task.MatterAcross = 300.0;
  task.Occupied = 0.1;
  return task;
}
}

TEST_CASE("Without shadows there is nothing to choose")
{
  ShadowChoiceTask task = MakeTask();
  task.SoftLights = 0;
  CHECK(ChooseShadowTechnique(task).Technique == ShadowTechnique::Rays);
}

TEST_CASE("The chosen technique is the cheapest of those within the tolerance")
{
  ShadowChoiceTask task = MakeTask();
  task.VoxelDepth = GENERATE(0.01, 0.1, 0.5, 3.1, 8.0);
  task.Occupied = GENERATE(0.01, 0.3, 1.0);
  task.HardLights = GENERATE(0, 1);
  task.Tolerance = GENERATE(0.1, 0.5, 1.0, 3.0, 10.0);
  const ShadowChoice choice = ChooseShadowTechnique(task);
  bool anyWithin = false;
  for (const ShadowOption other : Options)
  {
    const double error = PredictShadowError(other, task);
    anyWithin = anyWithin || error <= task.Tolerance;
    if (error <= task.Tolerance)
    {
      CHECK(PredictShadowCost(choice.Option, task) <= PredictShadowCost(other, task));
    }
  }
  CHECK((choice.PredictedError <= task.Tolerance) == anyWithin);
}

TEST_CASE("Every option is the choice of some scene")
{
  std::mt19937 generator(1);
  const auto draw = [&](double low, double high)
  { return low * std::pow(high / low, std::uniform_real_distribution<double>()(generator)); };
  std::set<ShadowOption> chosen;
  for (int scene = 0; scene < 5000; ++scene)
  {
    ShadowChoiceTask task = MakeTask();
    task.SoftLights = static_cast<int>(draw(1.0, 9.0));
    task.VoxelDepth = draw(0.02, 3.0);
    task.Pixels = std::pow(draw(128.0, 2048.0), 2);
    task.MatterAcross = draw(50.0, 800.0);
    task.VoxelsAcross = 1.5 * task.MatterAcross;
    task.Voxels = std::pow(task.MatterAcross, 3) / 4.0;
    task.Occupied = draw(0.01, 1.0);
    task.Tolerance = draw(0.2, 2.0);
    chosen.insert(ChooseShadowTechnique(task).Option);
  }
  for (const ShadowOption option : Options)
  {
    INFO(static_cast<int>(option));
    CHECK(chosen.count(option) == 1);
  }
}

TEST_CASE("Where nothing is within the tolerance the least error counts")
{
  ShadowChoiceTask task = MakeTask();
  task.SteepOpacity = true;
  task.Tolerance = 0.01;
  const ShadowChoice choice = ChooseShadowTechnique(task);
  for (const ShadowOption other : Options)
  {
    CHECK(choice.PredictedError <= PredictShadowError(other, task));
  }
  CHECK(choice.Reason.find("beyond") != std::string::npos);
}

TEST_CASE("Errors grow with the light that the shadows are of")
{
  const ShadowOption option = GENERATE(ShadowOption::Rays, ShadowOption::DeepMap);
  ShadowChoiceTask task = MakeTask();
  const double one = PredictShadowError(option, task);
  task.SoftLights = 4;
  CHECK(PredictShadowError(option, task) == one);
  task.Brightness = 2.0;
  CHECK(PredictShadowError(option, task) == Approx(2.0 * one));
}

TEST_CASE("A large volume on a small picture is not worth a volume of shadows")
{
  ShadowChoiceTask task = MakeTask();
  task.Pixels = 32.0 * 32.0;
  task.Occupied = 1.0;
  CHECK(ChooseShadowTechnique(task).Technique != ShadowTechnique::Volume);
}

TEST_CASE("Coarse slices count against a volume, as far as its texels are no coarser themselves")
{
  ShadowChoiceTask task = MakeTask();
  const double even = PredictShadowError(ShadowOption::MarchedVolume, task);
  const double coarse = PredictShadowError(ShadowOption::CoarseVolume, task);
  const double map = PredictShadowError(ShadowOption::DeepMap, task);
  task.SpacingRatio = 3.0;
  CHECK(PredictShadowError(ShadowOption::MarchedVolume, task) == Approx(1.5 * even));
  CHECK(PredictShadowError(ShadowOption::CoarseVolume, task) == Approx(coarse));
  task.SpacingRatio = 6.0;
  CHECK(PredictShadowError(ShadowOption::CoarseVolume, task) == Approx(1.5 * coarse));
  CHECK(PredictShadowError(ShadowOption::DeepMap, task) == map);
}

TEST_CASE(
  "A coarse volume is taken where it will do, with no step marched, and a fine one where not")
{
  ShadowChoiceTask task = MakeTask();
  task.VoxelDepth = 0.05;
  const ShadowChoice coarse = ChooseShadowTechnique(task);
  CHECK(coarse.Option == ShadowOption::CoarseVolume);
  CHECK(coarse.Technique == ShadowTechnique::Volume);
  CHECK(coarse.Resolution == 0.5);
  CHECK(coarse.NearSteps == 0);
  const double error = PredictShadowError(ShadowOption::CoarseVolume, task);
  REQUIRE(PredictShadowError(ShadowOption::MarchedVolume, task) < error);
  task.Tolerance = 0.999 * error;
  CHECK(ChooseShadowTechnique(task).Option != ShadowOption::CoarseVolume);
}

TEST_CASE("Shorter steps make rays better, and nothing that is kept")
{
  ShadowChoiceTask task = MakeTask();
  const double rays = PredictShadowError(ShadowOption::Rays, task);
  const double map = PredictShadowError(ShadowOption::DeepMap, task);
  task.ShadowStep = 0.25;
  CHECK(PredictShadowError(ShadowOption::Rays, task) == Approx(0.25 * rays));
  CHECK(PredictShadowError(ShadowOption::DeepMap, task) == map);
  task.SteepOpacity = true;
  CHECK(ChooseShadowTechnique(task).Technique == ShadowTechnique::Rays);
}

TEST_CASE("Memory makes opacity maps coarser, which counts against them")
{
  ShadowChoiceTask task = MakeTask();
  const ShadowOption option = ShadowOption::OpacityMap;
  const double fine = PredictShadowError(option, task);
  const double cost = PredictShadowCost(option, task);
  // 300 texels along each of three edges take 54 MB; so much less makes them half as many.
  task.LargestBytes = 300 * 300 * 300 * 2 / 8;
  CHECK(PredictShadowError(option, task) == Approx(std::pow(2.0, 1.5) * fine));
  CHECK(PredictShadowCost(option, task) < cost);
  // Four lights share the memory.
  task.SoftLights = 4;
  CHECK(PredictShadowError(option, task) == Approx(std::pow(2.0 * std::cbrt(4.0), 1.5) * fine));
}
