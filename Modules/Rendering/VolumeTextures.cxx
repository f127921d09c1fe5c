#include "VolumeTextures.h"

#include "GradientNoise.h"
#include "MatrixUniforms.h"
#include "VisibleScalars.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
constexpr int LargestTableSize = 8192;
constexpr int GradientOpacityTableSize = 8192;

bool IsInteger(int scalarType)
{
  return scalarType != VTK_FLOAT && scalarType != VTK_DOUBLE;
}

// In scalar units per mean voxel: the largest difference a voxel along each axis, and half as much
// again for what float rounding adds.
double BoundGradient(const ScalarRange& range, const double spacing[3], GradientEstimator estimator)
{
  const bool oneSided = estimator == GradientEstimator::ForwardDifferences ||
    estimator == GradientEstimator::BackwardDifferences;
  const double mean = (std::abs(spacing[0]) + std::abs(spacing[1]) + std::abs(spacing[2])) / 3.0;
  const double perVoxel = (oneSided ? 1.5 : 0.75) * (range.High - range.Low);
  return perVoxel * std::hypot(mean / spacing[0], mean / spacing[1], mean / spacing[2]);
}

void Prepare(vtkTextureObject* texture, vtkOpenGLRenderWindow* window, int filter)
{
  texture->SetContext(window);
  texture->ResetFormatAndType();
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetMinificationFilter(filter);
  texture->SetMagnificationFilter(filter);
}

// Scale and offset from what the scalar texture returns to the coordinate of an even table whose
// first and last entries, at the centres of their texels, belong to low and high.
std::array<double, 2> GetTableCoordinate(
  double low, double high, size_t size, double scale, double offset)
{
  const double texels = static_cast<double>(size);
  const double perScalar = (texels - 1.0) / (texels * (high - low));
  return { perScalar * scale, (offset - low) * perScalar + 0.5 / texels };
}
}

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
  this->IntegerData = IsInteger(scalars->GetDataType());
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
  return this->Gradients.Update(
    window, this->LoadedScalars, this->LoadedDimensions, this->ScalarsTime, estimator, bits);
}

//------------------------------------------------------------------------------
bool VolumeTextures::UpdateEmptySpace(vtkOpenGLRenderWindow* window, const CroppedRegions& regions)
{
  const vtkMTimeType changed =
    std::max(this->TransferFunctionTime.GetMTime(), this->MaskTime.GetMTime());
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
  if (this->GradientOpacityTexture->GetHandle())
  {
    visibility.LeastGradient = FindLeastVisibleGradient(this->GradientOpacity);
    visibility.GradientBound =
      BoundGradient({ 0.0, 1.0 }, this->LoadedImage->GetSpacing(), this->LoadedEstimator);
  }
  if (this->LoadedMask)
  {
    visibility.ShownByMask =
      FindShownBricks(this->LoadedMask->GetPointData()->GetScalars(), this->EmptySpace.GetGrid());
  }
  this->EmptySpace.Load(window, this->Table, visibility);
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
bool VolumeTextures::UpdateMask(vtkOpenGLRenderWindow* window, vtkImageData* mask)
{
  if (!mask)
  {
    if (this->LoadedMask)
    {
      this->MaskTime.Modified();
    }
    this->Mask->ReleaseGraphicsResources(window);
    this->LoadedMask = nullptr;
    return true;
  }
  if (this->Mask->GetHandle() && mask == this->LoadedMask && mask->GetMTime() < this->MaskTime)
  {
    return true;
  }
  std::array<int, 3> dimensions;
  mask->GetDimensions(dimensions.data());
  if (!LoadMask(this->Mask, window, mask->GetPointData()->GetScalars(), dimensions))
  {
    return false;
  }
  this->LoadedMask = mask;
  this->MaskTime.Modified();
  return true;
}

//------------------------------------------------------------------------------
void VolumeTextures::UpdateTransferFunctions(
  vtkOpenGLRenderWindow* window, vtkVolumeProperty* property, GradientEstimator estimator)
{
  const bool loaded = this->Extinction->GetHandle() || this->Points->GetHandle();
  if (loaded && property == this->LoadedProperty && estimator == this->LoadedEstimator &&
    std::max(property->GetMTime(), this->ScalarsTime.GetMTime()) < this->TransferFunctionTime)
  {
    return;
  }
  TransferFunctions functions;
  functions.Opacity = property->GetScalarOpacity(0);
  if (property->GetColorChannels(0) == 3)
  {
    functions.Color = property->GetRGBTransferFunction(0);
  }
  else
  {
    functions.Gray = property->GetGrayTransferFunction(0);
  }
  functions.UnitDistance = property->GetScalarOpacityUnitDistance(0);
  functions.DataLow = this->Scalars.GetRange().Low;
  functions.DataHigh = this->Scalars.GetRange().High;
  functions.IntegerData = this->IntegerData;
  const double* spacing = this->LoadedImage->GetSpacing();
  functions.Step = std::min({ std::abs(spacing[0]), std::abs(spacing[1]), std::abs(spacing[2]) });
  this->Table = MakeTransferFunctionTable(
    functions, std::min(LargestTableSize, vtkTextureObject::GetMaximumTextureSize(window)));
  for (vtkTextureObject* texture :
    { this->Extinction.Get(), this->Color.Get(), this->ColorIntegral.Get(), this->Points.Get() })
  {
    texture->ReleaseGraphicsResources(window);
  }
  if (this->Table.Lookup == TransferFunctionLookup::Table || this->Table.Steep)
  {
    this->LoadTable(window);
  }
  if (this->Table.Lookup == TransferFunctionLookup::Points)
  {
    this->LoadPoints(window);
  }
  this->LoadGradientOpacity(window, property, estimator);
  this->LoadedProperty = property;
  this->LoadedEstimator = estimator;
  this->TransferFunctionTime.Modified();
}

//------------------------------------------------------------------------------
void VolumeTextures::LoadTable(vtkOpenGLRenderWindow* window)
{
  Prepare(this->Extinction, window, vtkTextureObject::Linear);
  Prepare(this->Color, window, vtkTextureObject::Linear);
  const int size = this->Table.GetSize();
  this->Color->Create1DFromRaw(size, 3, VTK_FLOAT, this->Table.Color.data());
  if (!this->Table.Steep)
  {
    this->Extinction->Create1DFromRaw(size, 1, VTK_FLOAT, this->Table.Extinction.data());
    return;
  }
  std::vector<float> extinction;
  for (int entry = 0; entry < size; ++entry)
  {
    extinction.push_back(this->Table.Extinction[entry]);
    extinction.push_back(this->Table.ExtinctionIntegral[entry]);
  }
  this->Extinction->Create1DFromRaw(size, 2, VTK_FLOAT, extinction.data());
  Prepare(this->ColorIntegral, window, vtkTextureObject::Linear);
  this->ColorIntegral->Create1DFromRaw(size, 3, VTK_FLOAT, this->Table.ColorIntegral.data());
}

//------------------------------------------------------------------------------
void VolumeTextures::LoadPoints(vtkOpenGLRenderWindow* window)
{
  const int points = this->Table.GetNumberOfPoints();
  std::vector<float> rows(4 * static_cast<size_t>(points), 0.0f);
  const double scale = this->Scalars.GetEncoding().Scale;
  for (int point = 0; point < points; ++point)
  {
    rows[4 * point] = static_cast<float>(this->Table.PointScalars[point] / scale);
  }
  rows.insert(rows.end(), this->Table.PointColors.begin(), this->Table.PointColors.end());
  Prepare(this->Points, window, vtkTextureObject::Nearest);
  this->Points->Create2DFromRaw(points, 2, 4, VTK_FLOAT, rows.data());
}

//------------------------------------------------------------------------------
void VolumeTextures::LoadGradientOpacity(
  vtkOpenGLRenderWindow* window, vtkVolumeProperty* property, GradientEstimator estimator)
{
  if (!property->HasGradientOpacity(0) || property->GetDisableGradientOpacity(0))
  {
    this->GradientOpacityTexture->ReleaseGraphicsResources(window);
    return;
  }
  this->GradientOpacity = MakeGradientOpacityTable(property->GetGradientOpacity(0),
    std::min(GradientOpacityTableSize, vtkTextureObject::GetMaximumTextureSize(window)),
    BoundGradient(this->Scalars.GetRange(), this->LoadedImage->GetSpacing(), estimator));
  Prepare(this->GradientOpacityTexture, window, vtkTextureObject::Linear);
  this->GradientOpacityTexture->Create1DFromRaw(
    static_cast<unsigned int>(this->GradientOpacity.Opacity.size()), 1, VTK_FLOAT,
    this->GradientOpacity.Opacity.data());
}

//------------------------------------------------------------------------------
int VolumeTextures::GetLookupIterations() const
{
  if (this->Table.Lookup == TransferFunctionLookup::Table)
  {
    return 0;
  }
  return static_cast<int>(std::ceil(std::log2(std::max(this->Table.GetNumberOfPoints(), 2)))) + 1;
}

//------------------------------------------------------------------------------
std::vector<vtkTextureObject*> VolumeTextures::GetLoaded() const
{
  std::vector<vtkTextureObject*> loaded;
  for (vtkTextureObject* texture :
    std::initializer_list<vtkTextureObject*>{ this->Scalars.GetTexture(), this->Mask,
      this->Extinction, this->Color, this->ColorIntegral, this->Points,
      this->GradientOpacityTexture, this->Gradients.GetTexture(), this->EmptySpace.GetTexture() })
  {
    if (texture->GetHandle())
    {
      loaded.push_back(texture);
    }
  }
  return loaded;
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
  SetSampler(program, "scene_mask", this->Mask);
  SetSampler(program, "scene_extinction", this->Extinction);
  SetSampler(program, "scene_color", this->Color);
  SetSampler(program, "scene_colorIntegral", this->ColorIntegral);
  SetSampler(program, "scene_points", this->Points);
  SetSampler(program, "scene_gradientOpacity", this->GradientOpacityTexture);
  SetSampler(program, "scene_gradients", this->Gradients.GetTexture());
  this->EmptySpace.SetUniforms(program);
  SetUniform(program, "scene_gradientScale", this->Gradients.GetScale() / encoding.Scale);
  if (this->Extinction->GetHandle())
  {
    const auto coordinate = GetTableCoordinate(this->Table.Low, this->Table.High,
      this->Table.Extinction.size(), encoding.Scale, encoding.Offset);
    SetUniform(program, "scene_tableCoordinate", coordinate);
    this->SetIntegralUniforms(program);
  }
  if (this->Table.Lookup == TransferFunctionLookup::Points)
  {
    program->SetUniformi("scene_pointSearchSteps", this->GetLookupIterations());
    SetUniform(program, "scene_pointOffset", (this->Table.Low - encoding.Offset) / encoding.Scale);
    SetUniform(program, "scene_reciprocalUnitDistance", 1.0 / unitDistance);
  }
  if (!this->GradientOpacity.Opacity.empty())
  {
    const double range = this->GradientOpacity.High - this->GradientOpacity.Low;
    Matrix3 toTable = placement.GetGradientToMagnitude();
    for (double& element : toTable)
    {
      element *= encoding.Scale / range;
    }
    SetUniform(program, "scene_gradientToTable", toTable);
    SetUniform(program, "scene_gradientTableOffset", -this->GradientOpacity.Low / range);
  }
}

//------------------------------------------------------------------------------
void VolumeTextures::SetIntegralUniforms(vtkShaderProgram* program) const
{
  const double entries = this->Table.GetSize();
  const std::array<double, 2> ends = { 0.5 / entries, 1.0 - 0.5 / entries };
  SetUniform(program, "scene_tableEnds", ends);
  // Two entries, each rounded in the table and once more in its interpolation. 0 would take
  // rounding for steepness where there is no matter at all.
  constexpr double rounding = 1.0 / (1 << 22);
  constexpr double tooRoughForColor = 1e-4;
  constexpr double least = 1e-30;
  const double whole = this->Table.ExtinctionIntegral.back();
  SetUniform(program, "scene_integralRounding", std::max(rounding * whole, least));
  SetUniform(program, "scene_colorIntegralLeast", std::max(tooRoughForColor * whole, least));
}

//------------------------------------------------------------------------------
void VolumeTextures::Release(vtkOpenGLRenderWindow* window)
{
  this->Scalars.Release(window);
  this->Gradients.Release(window);
  this->EmptySpace.Release(window);
  for (vtkTextureObject* texture : { this->Mask.Get(), this->Extinction.Get(), this->Color.Get(),
         this->ColorIntegral.Get(), this->Points.Get(), this->GradientOpacityTexture.Get() })
  {
    texture->ReleaseGraphicsResources(window);
  }
  this->LoadedScalars = nullptr;
  this->LoadedImage = nullptr;
  this->LoadedMask = nullptr;
  this->LoadedProperty = nullptr;
}

}
