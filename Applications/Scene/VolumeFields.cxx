#include "VolumeFields.h"

#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkStringArray.h>

namespace penumbra
{

std::string TextField(vtkImageData* image, const char* name)
{
  auto* const texts = vtkStringArray::SafeDownCast(image->GetFieldData()->GetAbstractArray(name));
  return texts && texts->GetNumberOfValues() > 0 ? texts->GetValue(0) : std::string();
}

}
