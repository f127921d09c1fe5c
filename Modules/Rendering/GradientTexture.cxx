#include "GradientTexture.h"

#include "GradientDifferences.h"
#include "GradientField.h"
#include "OpenGLEnumerants.h"
#include "TextureSampling.h"

#include "vtkDataArray.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShortArray.h"

namespace penumbra
{

//------------------------------------------------------------------------------
bool GradientTexture::Update(vtkOpenGLRenderWindow* window, vtkDataArray* scalars,
  const std::array<int, 3>& dimensions, const ScalarRange& range, vtkMTimeType time,
  GradientEstimator estimator, int bits)
{
  const bool loaded = this->Texture->GetHandle() && scalars == this->LoadedScalars &&
    time < this->LoadTime && estimator == this->LoadedEstimator && bits == this->Report.Bits;
  if (loaded)
  {
    return true;
  }
  this->Release(window);
  ResetTexture(this->Texture, window, this->Filter);
  const bool isExact = bits == 16 && AreDifferencesExact(scalars->GetDataType(), range, estimator);
  if (!(isExact ? this->LoadDifferences(scalars, dimensions, estimator)
                : this->LoadQuantized(scalars, dimensions, estimator, bits)))
  {
    this->Release(window);
    return false;
  }
  this->LoadedScalars = scalars;
  this->LoadedEstimator = estimator;
  this->LoadTime.Modified();
  return true;
}

//------------------------------------------------------------------------------
bool GradientTexture::LoadDifferences(
  vtkDataArray* scalars, const std::array<int, 3>& dimensions, GradientEstimator estimator)
{
  const auto differences = ComputeGradientDifferences(scalars, dimensions, estimator);
  const auto values = static_cast<std::size_t>(differences->GetNumberOfValues());
  this->Report = { 16, values * sizeof(short), 0.0, 0.0 };
  this->Scale = GetDifferenceScale(estimator);
  return this->Load(dimensions, 16, differences->GetPointer(0));
}

//------------------------------------------------------------------------------
bool GradientTexture::LoadQuantized(vtkDataArray* scalars, const std::array<int, 3>& dimensions,
  GradientEstimator estimator, int bits)
{
  QuantizedGradientField field = QuantizeGradientField(scalars, dimensions, estimator, bits);
  this->Report = { field.Bits, field.Bytes, field.LargestError, field.MeanAngularError };
  this->Scale = field.Scale;
  return this->Load(dimensions, bits,
    bits == 16 ? static_cast<void*>(field.Values16.data()) : field.Values8.data());
}

//------------------------------------------------------------------------------
bool GradientTexture::Load(const std::array<int, 3>& dimensions, int bits, void* values)
{
  const bool isShort = bits == 16;
  this->Texture->SetInternalFormat(isShort ? GL_RGB16_SNORM : GL_RGB8_SNORM);
  this->Texture->SetFormat(GL_RGB);
  this->Texture->SetDataType(isShort ? GL_SHORT : GL_BYTE);
  return this->Texture->Create3DFromRaw(
    dimensions[0], dimensions[1], dimensions[2], 3, isShort ? VTK_SHORT : VTK_SIGNED_CHAR, values);
}

//------------------------------------------------------------------------------
void GradientTexture::SetInterpolation(bool linear)
{
  this->Filter = linear ? vtkTextureObject::Linear : vtkTextureObject::Nearest;
  SetSampling(this->Texture, this->Filter);
}

//------------------------------------------------------------------------------
void GradientTexture::Release(vtkOpenGLRenderWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->LoadedScalars = nullptr;
  this->Report = {};
}

}
