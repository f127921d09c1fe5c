#include "Catch.h"
#include "ImageComparison.h"
#include "PictureTest.h"
#include "SyntheticVolumes.h"

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkVolumeProperty.h>

#include <algorithm>

using namespace penumbra;

namespace
{
constexpr int Automatic = vtkIlluminatedVolumeMapper::AutomaticGradientTexture;

// The same scalars, no longer known to be whole.
void MakeFloat(IlluminatedScene& scene)
{
  vtkNew<vtkImageData> image;
  image->DeepCopy(scene.Mapper->GetInput());
  vtkNew<vtkFloatArray> scalars;
  scalars->DeepCopy(image->GetPointData()->GetScalars());
  image->GetPointData()->SetScalars(scalars);
  scene.Mapper->SetInputData(image);
}

std::unique_ptr<IlluminatedScene> MakeWaves(int estimator, int bits = 0)
{
  VolumeGrid grid;
  grid.dimensions = { 32, 32, 24 };
  grid.spacing = { 1.0, 1.0, 1.25 };
  auto scene = std::make_unique<IlluminatedScene>(MakeMarschnerLobb(grid));
  scene->AddDirectionalLight(-0.6, -0.7, -0.4, vtkVolumeLight::None);
  scene->Mapper->SetGradientEstimator(estimator);
  scene->Mapper->SetGradientTextureBits(bits);
  return scene;
}

Fault CentralDifferences()
{
  return { "central differences",
    [](IlluminatedScene& scene) { scene.Mapper->SetGradientEstimatorToCentralDifferences(); } };
}

void CheckEstimator(const std::string& name, int estimator)
{
  CheckPicture(name, [estimator] { return MakeWaves(estimator); },
    { CentralDifferences(), LightFromTheOtherSide() });
}

double LargestDifference(vtkImageData* left, vtkImageData* right)
{
  const auto* a = static_cast<unsigned char*>(left->GetScalarPointer());
  const auto* b = static_cast<unsigned char*>(right->GetScalarPointer());
  double largest = 0.0;
  for (vtkIdType value = 0; value < 3 * left->GetNumberOfPoints(); ++value)
  {
    largest = std::max(largest, std::abs(static_cast<double>(a[value]) - b[value]));
  }
  return largest;
}
}

TEST_CASE("Picture: forward differences", "[picture]")
{
  CheckEstimator("GradientForward", vtkIlluminatedVolumeMapper::ForwardDifferences);
}

TEST_CASE("Picture: backward differences", "[picture]")
{
  CheckEstimator("GradientBackward", vtkIlluminatedVolumeMapper::BackwardDifferences);
}

TEST_CASE("Picture: sobel", "[picture]")
{
  CheckEstimator("GradientSobel", vtkIlluminatedVolumeMapper::Sobel);
}

TEST_CASE("Gradients that are kept give the picture of those estimated at each sample")
{
  const int estimator = GENERATE(range(0, 4));
  const bool whole = GENERATE(true, false);
  const auto make = [&](int bits)
  {
    auto scene = MakeWaves(estimator, bits);
    if (!whole)
    {
      MakeFloat(*scene);
    }
    return scene;
  };
  const auto direct = make(0)->Render();
  const auto kept = make(16);
  // 16 bits are a 30,000th of the steepest gradient, which turns a normal by less than what is
  // seen; of whole scalars they are exact.
  CHECK(LargestDifference(direct, kept->Render()) <= 1.0);
  CHECK(kept->Mapper->GetGradientTextureBytes() == 32 * 32 * 24 * 3 * 2);
  CHECK((kept->Mapper->GetGradientTextureLargestError() > 0.0) == !whole);
  kept->Mapper->SetGradientTextureBits(8);
  // 8 bits are a 127th: faint gradients turn by degrees.
  CHECK(LargestDifference(direct, kept->Render()) <= 12.0);
  CHECK(kept->Mapper->GetGradientTextureBytes() == 32 * 32 * 24 * 3);
  kept->Mapper->SetGradientTextureBits(0);
  CHECK(LargestDifference(direct, kept->Render()) == 0.0);
  CHECK(kept->Mapper->GetGradientTextureBytes() == 0);
}

TEST_CASE("Gradients are kept by themselves where that is exact and small")
{
  const auto scene = MakeWaves(GENERATE(range(0, 4)), Automatic);
  const auto getBits = [&]
  {
    scene->Render();
    return scene->Mapper->GetActualGradientTextureBits();
  };
  CHECK(getBits() == 16);
  CHECK(scene->Mapper->GetGradientTextureLargestError() == 0.0);
  scene->Shade(false);
  CHECK(getBits() == 0);
  scene->Shade(true);
  MakeFloat(*scene);
  CHECK(getBits() == 0);
}

TEST_CASE("Gradients are not kept by themselves where they take more than 128 MiB")
{
  // Six bytes a voxel.
  const int slices = GENERATE(85, 86);
  VolumeGrid grid;
  grid.dimensions = { 512, 512, slices };
  IlluminatedScene scene(
    SampleField(grid, [](const Point& p) { return p[0] > 256.0 ? 200 : 0; }), 8, 8);
  scene.AddDirectionalLight(-0.6, -0.7, -0.4, vtkVolumeLight::None);
  scene.Render();
  CHECK(scene.Mapper->GetActualGradientTextureBits() == (slices == 85 ? 16 : 0));
}

TEST_CASE("Gradients that are kept follow the volume and the estimator")
{
  const auto kept = MakeWaves(vtkIlluminatedVolumeMapper::Sobel, 16);
  kept->Render();
  kept->Mapper->SetGradientEstimatorToForwardDifferences();
  CHECK(LargestDifference(kept->Render(),
          MakeWaves(vtkIlluminatedVolumeMapper::ForwardDifferences)->Render()) <= 1.0);
  VolumeGrid grid;
  grid.dimensions = { 32, 32, 24 };
  const auto other = MakeBall(grid, 9.0, 4.0);
  kept->Mapper->SetInputData(other);
  const auto direct = MakeWaves(vtkIlluminatedVolumeMapper::ForwardDifferences);
  direct->Mapper->SetInputData(other);
  CHECK(LargestDifference(kept->Render(), direct->Render()) <= 1.0);
}

TEST_CASE("Gradient opacity takes the estimator's gradient")
{
  // One-sided differences see twice the range that central ones do at a step.
  VolumeGrid grid;
  grid.dimensions = { 16, 16, 16 };
  const auto render = [&](int estimator)
  {
    IlluminatedScene scene(MakeSlab(grid, 2, 8.0, 16.0));
    scene.Shade(false);
    vtkNew<vtkPiecewiseFunction> steepOnly;
    steepOnly->AddPoint(150.0, 0.0);
    steepOnly->AddPoint(200.0, 1.0);
    scene.Volume->GetProperty()->SetGradientOpacity(steepOnly);
    scene.Mapper->SetGradientEstimator(estimator);
    return scene.Render();
  };
  const auto level = [](vtkImageData* picture)
  { return picture->GetScalarComponentAsDouble(64, 64, 0, 0); };
  const double background =
    render(vtkIlluminatedVolumeMapper::CentralDifferences)->GetScalarComponentAsDouble(0, 0, 0, 0);
  CHECK(level(render(vtkIlluminatedVolumeMapper::CentralDifferences)) == background);
  CHECK(level(render(vtkIlluminatedVolumeMapper::BackwardDifferences)) > background + 30.0);
}

// Rounding of a difference is a gradient like any other: its normal would be lit.
TEST_CASE("No estimator finds a normal in even matter")
{
  VolumeGrid grid;
  grid.dimensions = { 24, 16, 16 };
  grid.spacing = { 2.0, 2.0, 2.0 };
  grid.scalarType = VTK_SHORT;
  const double plateau = GENERATE(-1000.0, 77.0);
  IlluminatedScene scene(MakeSlab(grid, 0, 24.0, 46.0, { 2047.0, plateau }));
  const int estimator = GENERATE(range<int>(
    vtkIlluminatedVolumeMapper::CentralDifferences, vtkIlluminatedVolumeMapper::Sobel + 1));
  scene.Mapper->SetGradientEstimator(estimator);
  scene.Mapper->SetGradientTextureBits(GENERATE(0, 8, 16));
  scene.Mapper->CroppingOn();
  scene.Mapper->SetCroppingRegionPlanes(0.0, 18.0, 0.0, 30.0, 0.0, 30.0);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(plateau, 0.2);
  scene.Color->RemoveAllPoints();
  scene.Color->AddRGBPoint(plateau, 1.0, 1.0, 1.0);
  scene.Volume->GetProperty()->SetAmbient(0.0);
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  scene.AddDirectionalLight(-0.6, -0.7, -0.4, vtkVolumeLight::None);
  double brightest = 0.0;
  const auto picture = scene.Render();
  for (int channel = 0; channel < 3; ++channel)
  {
    brightest = std::max(brightest, picture->GetPointData()->GetScalars()->GetRange(channel)[1]);
  }
  CHECK(brightest == 0.0);
}
