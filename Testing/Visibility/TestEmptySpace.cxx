#include "Catch.h"
#include "ShadowedVolume.h"

using namespace penumbra;

// A function that is next to nothing where it was 0 leaves no brick empty.
TEST_CASE("Empty space is left out without changing anything")
{
  VolumeGrid grid;
  grid.dimensions = { 40, 33, 37 };
  const auto volume = MakeShells(grid, 21.0);
  const auto compute = [&](double nothing, bool hard)
  {
    ShadowedVolume scene(volume);
    scene.Opacity->RemoveAllPoints();
    scene.Opacity->AddPoint(0.0, nothing);
    scene.Opacity->AddPoint(190.0, nothing);
    scene.Opacity->AddPoint(200.0, 0.2);
    const auto light = scene.AddPoint({ 50.0, 60.0, 45.3 });
    light->SetShadow(hard ? vtkVolumeLight::Hard : vtkVolumeLight::Soft);
    light->SetOpacityThreshold(0.3);
    scene.Filter->SetSampleDistance(0.37);
    return scene.Compute();
  };
  const bool hard = GENERATE(false, true);
  const std::vector<float> visibility = compute(0.0, hard);
  CHECK(GetLargestDifference(visibility, compute(1e-30, hard)) == 0.0);
  CHECK(GetLargestDifference(visibility, std::vector<float>(visibility.size(), 1.0f)) > 0.9);
}
