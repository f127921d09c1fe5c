#include "ScalarTexture.h"

#include "TextureSampling.h"

#include "vtkDataArray.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>

namespace penumbra
{

//------------------------------------------------------------------------------
bool ScalarTexture::Load(
  vtkOpenGLRenderWindow* window, vtkDataArray* scalars, const std::array<int, 3>& dimensions)
{
  const int largest = vtkTextureObject::GetMaximumTextureSize3D(window);
  if (*std::max_element(dimensions.begin(), dimensions.end()) > largest)
  {
    return false;
  }
  const int type = scalars->GetDataType();
  this->Range = ComputeScalarRange(scalars);
  this->Encoding = ChooseEncoding(type, this->Range);
  this->Integers = type != VTK_FLOAT && type != VTK_DOUBLE;
  ResetTexture(this->Texture, window, vtkTextureObject::Linear);
  const auto create = [&](int valueType, void* values)
  {
    return this->Texture->Create3DFromRaw(
      dimensions[0], dimensions[1], dimensions[2], 1, valueType, values);
  };
  if (this->Encoding.Normalized)
  {
    return create(VTK_UNSIGNED_SHORT, EncodeNormalized(scalars, this->Encoding).data());
  }
  return create(VTK_FLOAT, EncodeFloat(scalars, this->Encoding, this->Range).data());
}

//------------------------------------------------------------------------------
void ScalarTexture::SetInterpolation(bool linear)
{
  SetSampling(this->Texture, linear ? vtkTextureObject::Linear : vtkTextureObject::Nearest);
}

//------------------------------------------------------------------------------
void ScalarTexture::Release(vtkOpenGLRenderWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
}

}
