#include "MaskTexture.h"

#include "TextureSampling.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <vector>

namespace penumbra
{

//------------------------------------------------------------------------------
bool MaskTexture::Update(vtkOpenGLRenderWindow* window, vtkImageData* mask)
{
  if (!mask)
  {
    if (this->LoadedMask)
    {
      this->Time.Modified();
    }
    this->Release(window);
    return true;
  }
  if (this->Texture->GetHandle() && mask == this->LoadedMask && mask->GetMTime() < this->Time)
  {
    return true;
  }
  if (!this->Load(window, mask))
  {
    return false;
  }
  this->LoadedMask = mask;
  this->Time.Modified();
  return true;
}

//------------------------------------------------------------------------------
bool MaskTexture::Load(vtkOpenGLRenderWindow* window, vtkImageData* mask)
{
  vtkDataArray* scalars = mask->GetPointData()->GetScalars();
  std::vector<unsigned char> values(scalars->GetNumberOfTuples());
  vtkSMPTools::For(0, scalars->GetNumberOfTuples(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType voxel = begin; voxel < end; ++voxel)
      {
        values[voxel] = scalars->GetComponent(voxel, 0) != 0.0 ? 255 : 0;
      }
    });
  ResetTexture(this->Texture, window, vtkTextureObject::Nearest);
  const int* dimensions = mask->GetDimensions();
  return this->Texture->Create3DFromRaw(
    dimensions[0], dimensions[1], dimensions[2], 1, VTK_UNSIGNED_CHAR, values.data());
}

//------------------------------------------------------------------------------
void MaskTexture::Release(vtkOpenGLRenderWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->LoadedMask = nullptr;
}

}
