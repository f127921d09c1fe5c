#include "Catch.h"
#include "ImageComparison.h"
#include "PictureTest.h"
#include "ReflectingScene.h"
#include "SyntheticVolumes.h"

#include <vtkTransform.h>

#include <algorithm>

using namespace penumbra;

namespace
{
using MaterialChange = std::function<void(vtkVolumeMaterial*)>;

SceneMaker MakerOf(const MaterialChange& change)
{
  return [change] { return MakeReflectingScene(change); };
}

Fault MaterialFault(const std::string& name, const MaterialChange& change)
{
  return { name, [change](IlluminatedScene& scene) { change(GetMaterial(scene)); } };
}

void Gild(vtkVolumeMaterial* material)
{
  material->SetReflectionModelToCookTorrance();
  material->SetDiffuse(0.3);
  material->SetSpecular(1.0);
  material->SetSlope(0.25);
  material->SetIndexOfRefraction(6.0, 4.0, 2.0);
}

Fault Phong()
{
  return MaterialFault("phong", [](vtkVolumeMaterial* m) { m->SetReflectionModelToPhong(); });
}
}

TEST_CASE("Picture: blinn-phong", "[picture]")
{
  CheckPicture("BlinnPhong",
    MakerOf([](vtkVolumeMaterial* m) { m->SetReflectionModelToBlinnPhong(); }),
    { Phong(), LightFromTheOtherSide(),
      MaterialFault("sharper", [](vtkVolumeMaterial* m) { m->SetSpecularPower(40.0); }) });
}

TEST_CASE("Picture: oren-nayar", "[picture]")
{
  CheckPicture("OrenNayar",
    MakerOf(
      [](vtkVolumeMaterial* m)
      {
        m->SetReflectionModelToOrenNayar();
        m->SetRoughness(0.6);
      }),
    { Phong(), LightFromTheOtherSide(),
      MaterialFault("Lambert's", [](vtkVolumeMaterial* m) { m->SetRoughness(0.0); }) });
}

TEST_CASE("Picture: ward", "[picture]")
{
  CheckPicture("Ward",
    MakerOf(
      [](vtkVolumeMaterial* m)
      {
        m->SetReflectionModelToWard();
        m->SetRoughness(0.2);
      }),
    { Phong(), LightFromTheOtherSide(),
      MaterialFault("rougher", [](vtkVolumeMaterial* m) { m->SetRoughness(0.3); }) });
}

TEST_CASE("Picture: ward anisotropic", "[picture]")
{
  CheckPicture("WardAnisotropic",
    MakerOf(
      [](vtkVolumeMaterial* m)
      {
        m->SetReflectionModelToWardAnisotropic();
        m->SetRoughnessX(0.1);
        m->SetRoughnessY(0.5);
        m->SetPreferredDirection(0.0, 2.0, 0.0);
      }),
    { Phong(), LightFromTheOtherSide(),
      MaterialFault(
        "brushed across", [](vtkVolumeMaterial* m) { m->SetPreferredDirection(1.0, 0.0, 0.0); }) });
}

TEST_CASE("Picture: cook-torrance", "[picture]")
{
  CheckPicture("CookTorrance", MakerOf(Gild),
    { Phong(), LightFromTheOtherSide(),
      MaterialFault(
        "grey", [](vtkVolumeMaterial* m) { m->SetIndexOfRefraction(4.0, 4.0, 4.0); }) });
}

TEST_CASE("Picture: cook-torrance with a Gaussian distribution", "[picture]")
{
  CheckPicture("CookTorranceGaussian",
    MakerOf(
      [](vtkVolumeMaterial* m)
      {
        Gild(m);
        m->SetDistributionToGaussian();
        m->SetGaussianConstant(4.0);
      }),
    { MaterialFault("Beckmann's", [](vtkVolumeMaterial* m) { m->SetDistributionToBeckmann(); }),
      MaterialFault(
        "another constant", [](vtkVolumeMaterial* m) { m->SetGaussianConstant(2.0); }) });
}

TEST_CASE("Picture: reflection map", "[picture]")
{
  CheckPicture("ReflectionMap",
    MakerOf(
      [](vtkVolumeMaterial* m)
      {
        m->SetReflectionModelToReflectionMap();
        m->SetEnvironmentMap(MakeSky());
      }),
    { Phong(), MaterialFault("sharper", [](vtkVolumeMaterial* m) { m->SetSpecularPower(80.0); }),
      MaterialFault(
        "no surroundings", [](vtkVolumeMaterial* m) { m->SetEnvironmentMap(nullptr); }) });
}

namespace
{
// A ball, brushed along an axis of its own and turned by quarter turns about x.
vtkSmartPointer<vtkImageData> RenderBrushedBall(const double direction[3], int quarterTurns)
{
  auto scene = MakeReflectingScene(
    [&](vtkVolumeMaterial* m)
    {
      m->SetReflectionModelToWardAnisotropic();
      m->SetPreferredDirection(direction[0], direction[1], direction[2]);
    });
  VolumeGrid grid;
  grid.dimensions = { 41, 41, 41 };
  scene->Mapper->SetInputData(MakeBall(grid, 16.0, 6.0));
  vtkNew<vtkTransform> turn;
  turn->Translate(20.0, 20.0, 20.0);
  turn->RotateX(90.0 * quarterTurns);
  turn->Translate(-20.0, -20.0, -20.0);
  scene->Volume->SetUserTransform(turn);
  return scene->Render();
}
}

TEST_CASE("A preferred direction turns with the volume, and its sign and length do not matter")
{
  const double alongY[3] = { 0.0, 1.0, 0.0 };
  const double againstZ[3] = { 0.0, 0.0, -3.0 };
  const auto expected = RenderBrushedBall(alongY, 0);
  // Turned, samples lie elsewhere by rounding alone.
  CHECK(CompareImages(RenderBrushedBall(againstZ, 1), expected).rmse < 0.5);
  CHECK(CompareImages(RenderBrushedBall(againstZ, 0), expected).rmse > 3.0);
}

TEST_CASE("Uniform surroundings are reflected uniformly")
{
  constexpr double radiance = 0.4;
  const auto scene = MakeReflectingScene(
    [=](vtkVolumeMaterial* m)
    {
      vtkNew<vtkImageData> image;
      image->SetDimensions(8, 4, 1);
      image->AllocateScalars(VTK_FLOAT, 1);
      std::fill_n(static_cast<float*>(image->GetScalarPointer()), 32, radiance);
      m->SetReflectionModelToReflectionMap();
      m->SetEnvironmentMap(image);
    });
  scene->Opacity->RemoveAllPoints();
  scene->Opacity->AddPoint(100.0, 0.0);
  scene->Opacity->AddPoint(110.0, 1.0);
  scene->Color->RemoveAllPoints();
  scene->Color->AddRGBPoint(0.0, 0.8, 0.6, 0.4);
  const auto picture = scene->Render();
  const double color[3] = { 0.8, 0.6, 0.4 };
  for (int channel = 0; channel < 3; ++channel)
  {
    const double expected = color[channel] * (0.15 + 0.6 * radiance) + 0.5 * radiance;
    for (const int x : { 54, 64, 74 })
    {
      // Half a grey level of rounding, and what is seen through opacity 0.9997.
      CHECK(picture->GetScalarComponentAsDouble(x, 64, 0, channel) ==
        Approx(255.0 * expected).margin(0.7));
    }
  }
}
