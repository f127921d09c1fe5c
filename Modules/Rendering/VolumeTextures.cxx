#include "VolumeTextures.h"

#include "GradientDifferences.h"
#include "GradientNoise.h"
#include "MatrixUniforms.h"
#include "VisibleScalars.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

namespace penumbra
{

//------------------------------------------------------------------------------
bool VolumeTextures::UpdateScalars(
  vtkOpenGLRenderWindow* window, vtkImageData* image, vtkDataArray* scalars)
{
  std::array<int, 3> dimensions;
  image->GetDimensions(dimensions.data());
  if (this->Scalars.GetTexture()->GetHandle() && scalars == this->LoadedScalars &&
    image == this->LoadedImage && dimensions == this->LoadedDimensions &&
    std::max(image->GetMTime(), scalars->GetMTime()) < this->ScalarsTime)
  {
    return true;
  }
  if (!this->Scalars.Load(window, scalars, dimensions))
  {
    return false;
  }
  this->EmptySpace.ForgetScalars();
  this->LoadedScalars = scalars;
  this->LoadedImage = image;
  this->LoadedDimensions = dimensions;
  this->ScalarsTime.Modified();
  return true;
}

//------------------------------------------------------------------------------
void VolumeTextures::SetInterpolation(bool linear)
{
  this->Scalars.SetInterpolation(linear);
  this->Gradients.SetInterpolation(linear);
}

//------------------------------------------------------------------------------
bool VolumeTextures::UpdateGradients(
  vtkOpenGLRenderWindow* window, GradientEstimator estimator, int bits)
{
  if (bits == 0)
  {
    this->Gradients.Release(window);
    return true;
  }
  return this->Gradients.Update(window, this->LoadedScalars, this->LoadedDimensions,
    this->Scalars.GetRange(), this->ScalarsTime, estimator, bits);
}

//------------------------------------------------------------------------------
int VolumeTextures::ChooseGradientBits(GradientEstimator estimator) const
{
  constexpr vtkIdType mostBytes = 128 << 20;
  constexpr vtkIdType bytesPerVoxel = 6;
  const bool fits = bytesPerVoxel * this->LoadedScalars->GetNumberOfTuples() <= mostBytes;
  return fits &&
      AreDifferencesExact(this->LoadedScalars->GetDataType(), this->Scalars.GetRange(), estimator)
    ? 16
    : 0;
}

//------------------------------------------------------------------------------
bool VolumeTextures::UpdateEmptySpace(vtkOpenGLRenderWindow* window, const CroppedRegions& regions)
{
  const vtkMTimeType changed =
    std::max(this->TransferFunctionTime.GetMTime(), this->Mask.GetTime());
  if (this->EmptySpace.GetTexture()->GetHandle() && changed < this->EmptySpaceTime &&
    regions == this->LoadedRegions)
  {
    return this->EmptySpace.GetReport().Helps();
  }
  if (!this->EmptySpace.HasBricks())
  {
    this->EmptySpace.ComputeBricks(
      this->LoadedScalars, this->LoadedDimensions, this->Scalars.GetRange());
  }
  BrickVisibility visibility;
  visibility.Regions = regions;
  this->GradientOpacity.Describe(visibility);
  if (vtkImageData* mask = this->Mask.GetMask())
  {
    visibility.ShownByMask =
      FindShownBricks(mask->GetPointData()->GetScalars(), this->EmptySpace.GetGrid());
  }
  this->EmptySpace.Load(window, this->TransferFunctions.GetTable(), visibility);
  this->LoadedRegions = regions;
  this->EmptySpaceTime.Modified();
  return this->EmptySpace.GetReport().Helps();
}

//------------------------------------------------------------------------------
void VolumeTextures::DropEmptySpace(vtkOpenGLRenderWindow* window)
{
  this->EmptySpace.Release(window);
}

//------------------------------------------------------------------------------
double VolumeTextures::GetNoise()
{
  if (this->NoiseTime < this->ScalarsTime)
  {
    this->Noise = EstimateNoise(this->LoadedScalars, this->LoadedDimensions);
    this->NoiseTime.Modified();
  }
  return this->Noise;
}

//------------------------------------------------------------------------------
void VolumeTextures::UpdateTransferFunctions(
  vtkOpenGLRenderWindow* window, vtkVolumeProperty* property, GradientEstimator estimator)
{
  if (this->TransferFunctions.IsLoaded() && property == this->LoadedProperty &&
    estimator == this->LoadedEstimator &&
    std::max(property->GetMTime(), this->ScalarsTime.GetMTime()) < this->TransferFunctionTime)
  {
    return;
  }
  const double* spacing = this->LoadedImage->GetSpacing();
  this->TransferFunctions.Load(window, property, this->Scalars, spacing);
  this->GradientOpacity.Load(window, property, this->Scalars.GetRange(), spacing, estimator);
  this->LoadedProperty = property;
  this->LoadedEstimator = estimator;
  this->TransferFunctionTime.Modified();
}

//------------------------------------------------------------------------------
std::vector<vtkTextureObject*> VolumeTextures::GetLoaded() const
{
  std::vector<vtkTextureObject*> textures = { this->Scalars.GetTexture(), this->Mask.GetTexture() };
  const auto functions = this->TransferFunctions.GetTextures();
  textures.insert(textures.end(), functions.begin(), functions.end());
  textures.insert(textures.end(),
    { this->GradientOpacity.GetTexture(), this->Gradients.GetTexture(),
      this->EmptySpace.GetTexture() });
  textures.erase(std::remove_if(textures.begin(), textures.end(),
                   [](vtkTextureObject* texture) { return texture->GetHandle() == 0; }),
    textures.end());
  return textures;
}

//------------------------------------------------------------------------------
void VolumeTextures::Activate()
{
  for (vtkTextureObject* texture : this->GetLoaded())
  {
    texture->Activate();
  }
}

//------------------------------------------------------------------------------
void VolumeTextures::Deactivate()
{
  for (vtkTextureObject* texture : this->GetLoaded())
  {
    texture->Deactivate();
  }
}

//------------------------------------------------------------------------------
void VolumeTextures::SetUniforms(
  vtkShaderProgram* program, const VolumePlacement& placement, double unitDistance) const
{
  const ScalarEncoding& encoding = this->Scalars.GetEncoding();
  SetSampler(program, "scene_scalars", this->Scalars.GetTexture());
  SetSampler(program, "scene_mask", this->Mask.GetTexture());
  SetSampler(program, "scene_gradients", this->Gradients.GetTexture());
  SetUniform(program, "scene_gradientScale", this->Gradients.GetScale() / encoding.Scale);
  this->EmptySpace.SetUniforms(program);
  this->TransferFunctions.SetUniforms(program, encoding, unitDistance);
  this->GradientOpacity.SetUniforms(program, placement, encoding.Scale);
}

//------------------------------------------------------------------------------
void VolumeTextures::Release(vtkOpenGLRenderWindow* window)
{
  this->Scalars.Release(window);
  this->Mask.Release(window);
  this->TransferFunctions.Release(window);
  this->GradientOpacity.Release(window);
  this->Gradients.Release(window);
  this->EmptySpace.Release(window);
  this->LoadedScalars = nullptr;
  this->LoadedImage = nullptr;
  this->LoadedProperty = nullptr;
}

}
