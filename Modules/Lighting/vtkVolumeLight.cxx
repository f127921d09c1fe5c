#include "vtkVolumeLight.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkVolumeLight);

//------------------------------------------------------------------------------
vtkVolumeLight::vtkVolumeLight()
{
  this->SetAmbientColor(1.0, 1.0, 1.0);
}

//------------------------------------------------------------------------------
vtkVolumeLight::~vtkVolumeLight() = default;

//------------------------------------------------------------------------------
const char* vtkVolumeLight::GetShadowAsString()
{
  switch (this->Shadow)
  {
    case Soft:
      return "Soft";
    case Hard:
      return "Hard";
    default:
      return "None";
  }
}

//------------------------------------------------------------------------------
vtkLight* vtkVolumeLight::ShallowClone()
{
  vtkVolumeLight* clone = vtkVolumeLight::New();
  clone->DeepCopy(this);
  clone->SetTransformMatrix(this->GetTransformMatrix());
  clone->Shadow = this->Shadow;
  clone->OpacityThreshold = this->OpacityThreshold;
  clone->ShadowBias = this->ShadowBias;
  return clone;
}

//------------------------------------------------------------------------------
void vtkVolumeLight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Shadow: " << this->GetShadowAsString() << "\n";
  os << indent << "OpacityThreshold: " << this->OpacityThreshold << "\n";
  os << indent << "ShadowBias: " << this->ShadowBias << "\n";
}
