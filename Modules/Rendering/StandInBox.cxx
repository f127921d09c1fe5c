#include "StandInBox.h"

#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

namespace penumbra
{

//------------------------------------------------------------------------------
StandInBox::StandInBox()
{
  this->Image->SetDimensions(2, 2, 2);
  this->Image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  std::fill_n(
    static_cast<unsigned char*>(this->Image->GetScalarPointer()), 8, static_cast<unsigned char>(0));
  this->Mapper->SetInputData(this->Image);
  this->Mapper->AutoAdjustSampleDistancesOff();
  this->Mapper->UseJitteringOff();
  this->Volume->SetMapper(this->Mapper);
  this->Volume->SetUserMatrix(this->Matrix);
  vtkNew<vtkInformation> keys;
  this->Volume->SetPropertyKeys(keys);
}

//------------------------------------------------------------------------------
StandInBox::~StandInBox() = default;

//------------------------------------------------------------------------------
void StandInBox::Place(const VolumePlacement& placement)
{
  // Sides in world lengths: the ray caster moves the near plane by a fraction of the clipping
  // range.
  double sides[3];
  this->BoxToTexture = Matrix4{};
  this->BoxToTexture[15] = 1.0;
  vtkNew<vtkMatrix4x4> matrix;
  for (int axis = 0; axis < 3; ++axis)
  {
    Vector3 edge{};
    edge[axis] = placement.FullBoxHigh[axis] - placement.FullBoxLow[axis];
    const Vector3 side = MultiplyDirection(placement.TextureToWorld, edge);
    sides[axis] = GetLength(side);
    this->BoxToTexture[5 * axis] = edge[axis] / sides[axis];
    this->BoxToTexture[4 * axis + 3] = placement.FullBoxLow[axis];
    for (int row = 0; row < 3; ++row)
    {
      matrix->SetElement(row, axis, side[row] / sides[axis]);
    }
  }
  const Vector3 corner = MultiplyPoint(placement.TextureToWorld, placement.FullBoxLow);
  for (int row = 0; row < 3; ++row)
  {
    matrix->SetElement(row, 3, corner[row]);
  }
  if (!std::equal(sides, sides + 3, this->Image->GetSpacing()))
  {
    this->Image->SetSpacing(sides);
  }
  if (!std::equal(matrix->GetData(), matrix->GetData() + 16, this->Matrix->GetData()))
  {
    this->Matrix->DeepCopy(matrix);
  }
}

//------------------------------------------------------------------------------
Matrix4 StandInBox::GetBoxToClip(const Matrix4& textureToClip) const
{
  Matrix4 product;
  vtkMatrix4x4::Multiply4x4(textureToClip.data(), this->BoxToTexture.data(), product.data());
  return product;
}

//------------------------------------------------------------------------------
void StandInBox::Draw(vtkRenderer* renderer, vtkOpenGLRenderPass* pass)
{
  vtkInformation* keys = this->Volume->GetPropertyKeys();
  keys->Append(vtkOpenGLRenderPass::RenderPasses(), pass);
  this->Mapper->Render(renderer, this->Volume);
  keys->Remove(vtkOpenGLRenderPass::RenderPasses());
}

//------------------------------------------------------------------------------
void StandInBox::Release(vtkWindow* window)
{
  this->Mapper->ReleaseGraphicsResources(window);
}

}
