// What a mapper tells of itself and of its last picture.

#include "vtkIlluminatedVolumeMapperInternals.h"

#include <algorithm>

using namespace penumbra;

//------------------------------------------------------------------------------
const LightingRequirements& vtkIlluminatedVolumeMapper::GetRequirements() const
{
  return this->Internal->Scene.Requirements;
}

//------------------------------------------------------------------------------
double vtkIlluminatedVolumeMapper::GetActualSampleDistance() const
{
  return this->Internal->Scene.Plan.SampleDistance;
}

//------------------------------------------------------------------------------
double vtkIlluminatedVolumeMapper::GetActualShadowSampleDistance() const
{
  return this->Internal->Scene.Plan.ShadowSampleDistance;
}

//------------------------------------------------------------------------------
double vtkIlluminatedVolumeMapper::GetActualImageSampleDistance() const
{
  return this->Internal->ImageSampleDistance;
}

//------------------------------------------------------------------------------
int vtkIlluminatedVolumeMapper::GetActualShadowNearSteps() const
{
  return this->Internal->Shadows.NearSteps;
}

//------------------------------------------------------------------------------
const std::string& vtkIlluminatedVolumeMapper::GetShadowTechniqueReason() const
{
  return this->Internal->Shadows.Reason;
}

//------------------------------------------------------------------------------
std::size_t vtkIlluminatedVolumeMapper::GetShadowBytes() const
{
  return this->Internal->Drawing.GetShadowReport().Bytes;
}

//------------------------------------------------------------------------------
double vtkIlluminatedVolumeMapper::GetActualShadowResolution() const
{
  const DrawnScene& scene = this->Internal->Scene;
  return std::max({ scene.VolumeOfShadows.Resolution, scene.MapsOfShadows.Resolution,
    scene.LayersOfShadows.Resolution });
}

//------------------------------------------------------------------------------
bool vtkIlluminatedVolumeMapper::GetShadowsComplete() const
{
  return this->Internal->ShadowsComplete;
}

//------------------------------------------------------------------------------
int vtkIlluminatedVolumeMapper::GetNumberOfShadowUpdates() const
{
  return this->Internal->Drawing.GetShadowReport().Updates;
}

//------------------------------------------------------------------------------
double vtkIlluminatedVolumeMapper::GetShadowUpdateSeconds() const
{
  return this->Internal->Drawing.GetShadowReport().UpdateSeconds;
}

//------------------------------------------------------------------------------
int vtkIlluminatedVolumeMapper::GetNumberOfDraws() const
{
  return this->Internal->Scene.Plan.Draws;
}

//------------------------------------------------------------------------------
int vtkIlluminatedVolumeMapper::GetNumberOfShaderBuilds() const
{
  return this->Internal->Drawing.GetPass()->GetNumberOfBuilds();
}

//------------------------------------------------------------------------------
int vtkIlluminatedVolumeMapper::GetActualGradientTextureBits() const
{
  return this->Internal->GetGradients().Bits;
}

//------------------------------------------------------------------------------
std::size_t vtkIlluminatedVolumeMapper::GetGradientTextureBytes() const
{
  return this->Internal->GetGradients().Bytes;
}

//------------------------------------------------------------------------------
double vtkIlluminatedVolumeMapper::GetGradientTextureLargestError() const
{
  return this->Internal->GetGradients().LargestError;
}

//------------------------------------------------------------------------------
double vtkIlluminatedVolumeMapper::GetGradientTextureAngularError() const
{
  return this->Internal->GetGradients().MeanAngularError;
}

//------------------------------------------------------------------------------
int vtkIlluminatedVolumeMapper::GetNumberOfBricks() const
{
  return this->SkipEmptySpace ? this->Internal->GetEmptySpace().Bricks : 0;
}

//------------------------------------------------------------------------------
int vtkIlluminatedVolumeMapper::GetNumberOfOccupiedBricks() const
{
  return this->SkipEmptySpace ? this->Internal->GetEmptySpace().OccupiedBricks : 0;
}

//------------------------------------------------------------------------------
int vtkIlluminatedVolumeMapper::GetBrickEdge() const
{
  return this->SkipEmptySpace ? this->Internal->GetEmptySpace().BrickEdge : 0;
}

//------------------------------------------------------------------------------
double vtkIlluminatedVolumeMapper::GetMeanVoxelDepth() const
{
  return this->Internal->GetEmptySpace().MeanExtinction *
    this->Internal->Scene.Placement.SmallestSpacing;
}

//------------------------------------------------------------------------------
double vtkIlluminatedVolumeMapper::GetNumberOfSamples() const
{
  return this->Internal->Counts.Samples;
}

//------------------------------------------------------------------------------
double vtkIlluminatedVolumeMapper::GetNumberOfShadedSamples() const
{
  return this->Internal->Counts.ShadedSamples;
}

//------------------------------------------------------------------------------
double vtkIlluminatedVolumeMapper::GetNumberOfShadowSteps() const
{
  return this->Internal->Counts.ShadowSteps;
}

//------------------------------------------------------------------------------
const std::string& vtkIlluminatedVolumeMapper::GetFragmentShaderSource() const
{
  return this->Internal->Drawing.GetPass()->GetFragmentSource();
}

//------------------------------------------------------------------------------
const std::vector<std::string>& vtkIlluminatedVolumeMapper::GetMessages() const
{
  return this->Internal->Messages;
}

//------------------------------------------------------------------------------
void vtkIlluminatedVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  static const char* const techniques[] = { "Auto", "Rays", "Volume", "Map", "DeepMap",
    "OpacityMap" };
  static const char* const estimators[] = { "CentralDifferences", "ForwardDifferences",
    "BackwardDifferences", "Sobel" };
  static const char* const models[] = { "ByShade", "Absorption", "Emission", "AbsorptionEmission",
    "SingleScattering" };
  const auto print = [&](const char* name, const auto& value)
  { os << indent << name << ": " << value << "\n"; };
  print("ShadowTechnique", techniques[this->ShadowTechnique]);
  print("ShadowTolerance", this->ShadowTolerance);
  print("ShadowResolution", this->ShadowResolution);
  print("ShadowNearSteps", this->ShadowNearSteps);
  print("ShadowMemoryLimit", this->ShadowMemoryLimit);
  print("ShadowUpdateTime", this->ShadowUpdateTime);
  print("ShadowSampleDistance", this->ShadowSampleDistance);
  print("GradientEstimator", estimators[this->GradientEstimator]);
  print("GradientTextureBits", this->GradientTextureBits);
  print("SkipEmptySpace", this->SkipEmptySpace ? "On" : "Off");
  print("RayCounting", this->RayCounting ? "On" : "Off");
  print("OpticalModel", models[this->OpticalModel]);
  print("ShadowTechniqueReason", this->GetShadowTechniqueReason());
  print("ShadowsComplete", this->GetShadowsComplete() ? "Yes" : "No");
  print("ShadowBytes", this->GetShadowBytes());
  print("ActualShadowResolution", this->GetActualShadowResolution());
  print("ActualShadowNearSteps", this->GetActualShadowNearSteps());
  print("NumberOfShadowUpdates", this->GetNumberOfShadowUpdates());
  print("ShadowUpdateSeconds", this->GetShadowUpdateSeconds());
  print("ActualGradientTextureBits", this->GetActualGradientTextureBits());
  print("GradientTextureBytes", this->GetGradientTextureBytes());
  print("GradientTextureLargestError", this->GetGradientTextureLargestError());
  print("GradientTextureAngularError", this->GetGradientTextureAngularError());
  print("NumberOfBricks", this->GetNumberOfBricks());
  print("NumberOfOccupiedBricks", this->GetNumberOfOccupiedBricks());
  print("BrickEdge", this->GetBrickEdge());
  print("MeanVoxelDepth", this->GetMeanVoxelDepth());
  print("ActualSampleDistance", this->GetActualSampleDistance());
  print("ActualShadowSampleDistance", this->GetActualShadowSampleDistance());
  print("ActualImageSampleDistance", this->GetActualImageSampleDistance());
  print("NumberOfDraws", this->GetNumberOfDraws());
  print("NumberOfSamples", this->GetNumberOfSamples());
  print("NumberOfShadedSamples", this->GetNumberOfShadedSamples());
  print("NumberOfShadowSteps", this->GetNumberOfShadowSteps());
  print("NumberOfShaderBuilds", this->GetNumberOfShaderBuilds());
  print("NumberOfMessages", this->GetMessages().size());
}
