#include "Catch.h"
#include "ShadowedVolume.h"

#include <vtkRTAnalyticSource.h>

using namespace penumbra;

namespace
{
void Prepare(ShadowedVolume& scene)
{
  scene.Opacity->AddPoint(255.0, 0.5);
  scene.AddDirectional({ 1.0, 0.4, 0.2 });
}
}

TEST_CASE("A piece of the output needs the whole of the input")
{
  vtkNew<vtkRTAnalyticSource> source;
  source->SetWholeExtent(0, 8, 0, 8, 0, 8);
  const auto prepare = [&](ShadowedVolume& scene)
  {
    Prepare(scene);
    scene.Filter->SetInputConnection(source->GetOutputPort());
  };
  ShadowedVolume whole(nullptr);
  prepare(whole);
  const std::vector<float> expected = whole.Compute();
  source->Modified();
  ShadowedVolume piece(nullptr);
  prepare(piece);
  const int extent[6] = { 1, 1, 2, 2, 3, 3 };
  piece.Filter->UpdateExtent(extent);
  CHECK(piece.Filter->GetOutput()->GetScalarComponentAsFloat(1, 2, 3, 0) ==
    expected[1 + 9 * (2 + 9 * 3)]);
}

TEST_CASE("A piece of the output is the same as in the whole")
{
  ShadowedVolume scene(MakeShells(VolumeGrid{ { 9, 13, 7 } }, 5.0));
  Prepare(scene);
  const std::vector<float> whole = scene.Compute();
  const int extent[6] = { 2, 5, 3, 3, 1, 6 };
  ShadowedVolume piece(scene.Volume);
  Prepare(piece);
  piece.Filter->UpdateExtent(extent);
  vtkImageData* output = piece.Filter->GetOutput();
  REQUIRE(output->GetNumberOfPoints() == 4 * 1 * 6);
  for (int z = 1; z <= 6; ++z)
  {
    for (int x = 2; x <= 5; ++x)
    {
      CHECK(output->GetScalarComponentAsFloat(x, 3, z, 0) == whole[x + 9 * (3 + 13 * z)]);
    }
  }
}
