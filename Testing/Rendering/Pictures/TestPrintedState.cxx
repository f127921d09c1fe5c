#include "Catch.h"
#include "IlluminatedScene.h"
#include "SyntheticVolumes.h"

#include <sstream>

using namespace penumbra;

namespace
{
std::string Print(vtkObject* object)
{
  std::ostringstream text;
  object->Print(text);
  return text.str();
}
}

TEST_CASE("A mapper prints all that it was told, enumerators by name")
{
  vtkNew<vtkIlluminatedVolumeMapper> mapper;
  mapper->SetShadowTechniqueToDeepMap();
  mapper->SetShadowTolerance(2.5);
  mapper->SetShadowResolution(0.75);
  mapper->SetShadowNearSteps(7);
  mapper->SetShadowMemoryLimit(99);
  mapper->SetShadowUpdateTime(0.25);
  mapper->SetShadowSampleDistance(1.5);
  mapper->SetGradientEstimatorToSobel();
  mapper->SetGradientTextureBits(16);
  mapper->SkipEmptySpaceOff();
  mapper->RayCountingOn();
  mapper->SetOpticalModelToEmission();
  const std::string printed = Print(mapper);
  for (const char* line :
    { "ShadowTechnique: DeepMap\n", "ShadowTolerance: 2.5\n", "ShadowResolution: 0.75\n",
      "ShadowNearSteps: 7\n", "ShadowMemoryLimit: 99\n", "ShadowUpdateTime: 0.25\n",
      "ShadowSampleDistance: 1.5\n", "GradientEstimator: Sobel\n", "GradientTextureBits: 16\n",
      "SkipEmptySpace: Off\n", "RayCounting: On\n", "OpticalModel: Emission\n" })
  {
    CHECK_THAT(printed, Catch::Matchers::ContainsSubstring(line));
  }
}

TEST_CASE("A mapper prints what its last picture took")
{
  IlluminatedScene scene(MakeShells(VolumeGrid{ { 16, 16, 16 } }, 7.0), 32, 32);
  scene.AddDirectionalLight(1.0, 2.0, 3.0, vtkVolumeLight::Soft);
  scene.Mapper->SetShadowTechniqueToVolume();
  scene.Render();
  const std::string printed = Print(scene.Mapper);
  for (const char* line : { "ShadowTechniqueReason: as asked\n", "ActualShadowNearSteps: 4\n",
         "NumberOfShadowUpdates: 1\n", "GradientTextureBytes: 24576\n",
         "ActualGradientTextureBits: 16\n", "BrickEdge: 4\n", "ActualImageSampleDistance: 1\n",
         "NumberOfDraws: 1\n", "NumberOfMessages: 0\n" })
  {
    CHECK_THAT(printed, Catch::Matchers::ContainsSubstring(line));
  }
}
