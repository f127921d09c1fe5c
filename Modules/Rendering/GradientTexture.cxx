#include "GradientTexture.h"

#include "GradientField.h"
#include "OpenGLEnumerants.h"
#include "TextureSampling.h"

#include "vtkOpenGLRenderWindow.h"

namespace penumbra
{

//------------------------------------------------------------------------------
bool GradientTexture::Update(vtkOpenGLRenderWindow* window, vtkDataArray* scalars,
  const std::array<int, 3>& dimensions, vtkMTimeType time, GradientEstimator estimator, int bits)
{
  const bool loaded = this->Texture->GetHandle() && scalars == this->LoadedScalars &&
    time < this->LoadTime && estimator == this->LoadedEstimator && bits == this->Report.Bits;
  if (loaded)
  {
    return true;
  }
  this->Release(window);
  QuantizedGradientField field = QuantizeGradientField(scalars, dimensions, estimator, bits);
  const bool isShort = field.Bits == 16;
  void* values = isShort ? static_cast<void*>(field.Values16.data()) : field.Values8.data();
  ResetTexture(this->Texture, window, this->Filter);
  this->Texture->SetInternalFormat(isShort ? GL_RGB16_SNORM : GL_RGB8_SNORM);
  this->Texture->SetFormat(GL_RGB);
  this->Texture->SetDataType(isShort ? GL_SHORT : GL_BYTE);
  if (!this->Texture->Create3DFromRaw(dimensions[0], dimensions[1], dimensions[2], 3,
        isShort ? VTK_SHORT : VTK_SIGNED_CHAR, values))
  {
    this->Release(window);
    return false;
  }
  this->LoadedScalars = scalars;
  this->LoadedEstimator = estimator;
  this->Report = { field.Bits, field.Bytes, field.LargestError, field.MeanAngularError };
  this->Scale = field.Scale;
  this->LoadTime.Modified();
  return true;
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
