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
  return clone;
}

//------------------------------------------------------------------------------
void vtkVolumeLight::DeepCopy(vtkLight* light)
{
  this->Superclass::DeepCopy(light);
  if (auto* volumeLight = vtkVolumeLight::SafeDownCast(light))
  {
    this->SetShadow(volumeLight->GetShadow());
    this->SetOpacityThreshold(volumeLight->GetOpacityThreshold());
    this->SetShadowBias(volumeLight->GetShadowBias());
  }
}

//------------------------------------------------------------------------------
void vtkVolumeLight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Shadow: " << this->GetShadowAsString() << "\n";
  os << indent << "OpacityThreshold: " << this->OpacityThreshold << "\n";
  os << indent << "ShadowBias: " << this->ShadowBias << "\n";
}
