#include "PictureTest.h"

#include "Catch.h"
#include "ImageComparison.h"
#include "ReferencePicture.h"

#include <vtkLight.h>
#include <vtkLightCollection.h>

namespace penumbra
{
namespace
{
// One renderer gives the same bytes; another driver filters textures with fewer bits, which stays
// below one grey level. The mildest of the faults is several times as far.
constexpr ComparisonThresholds Thresholds = { 1.0, 0.99 };

// At steps of half a voxel.
constexpr double LargestErrorFromReference = 1.0;

bool IsWithin(const ImageDifference& difference)
{
  return difference.rmse <= Thresholds.maxRmse && difference.ssim >= Thresholds.minSsim;
}
}

//------------------------------------------------------------------------------
Fault LightFromTheOtherSide()
{
  return { "light from the other side",
    [](IlluminatedScene& scene)
    {
      vtkLight* light = scene.GetLight();
      double position[3];
      double focalPoint[3];
      light->GetPosition(position);
      light->GetFocalPoint(focalPoint);
      light->SetPosition(focalPoint);
      light->SetFocalPoint(position);
    } };
}

//------------------------------------------------------------------------------
Fault NoShadow()
{
  return { "no shadow", [](IlluminatedScene& scene) { scene.GetLight()->SetShadowToNone(); } };
}

//------------------------------------------------------------------------------
Fault HalfTheDensity()
{
  return { "half the density",
    [](IlluminatedScene& scene)
    {
      double node[4];
      for (int i = 0; i < scene.Opacity->GetSize(); ++i)
      {
        scene.Opacity->GetNodeValue(i, node);
        node[1] *= 0.5;
        scene.Opacity->SetNodeValue(i, node);
      }
    } };
}

//------------------------------------------------------------------------------
void CheckPicture(const std::string& name, const SceneMaker& make, const std::vector<Fault>& faults)
{
  const auto scene = make();
  const auto picture = scene->Render();
  CHECK(CompareWithBaseline(picture, name, Thresholds));
  CHECK(CompareImages(picture, RenderReference(*scene)).rmse <= LargestErrorFromReference);
  const auto baseline = ReadPNG(BaselineFolders::OfProject().baselines + "/" + name + ".png");
  for (const Fault& fault : faults)
  {
    INFO("with a fault: " << fault.Name);
    auto broken = make();
    fault.Break(*broken);
    const ImageDifference difference = CompareImages(broken->Render(), baseline);
    INFO("rmse " << difference.rmse << " ssim " << difference.ssim);
    CHECK_FALSE(IsWithin(difference));
  }
}

}
