#include "MovingSettings.h"

#include "VolumeBox.h"

#include <vtkIlluminatedVolumeMapper.h>
#include <vtkImageData.h>

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
double ResolutionOfMaps(vtkImageData* volume)
{
  double squared = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    squared += std::pow(volume->GetSpacing()[axis] * volume->GetDimensions()[axis], 2.0);
  }
  return MovingSettings::TexelsOfShadows * SmallestSpacing(volume) / std::sqrt(squared);
}
}

//------------------------------------------------------------------------------
MovingSettings::MovingSettings(vtkIlluminatedVolumeMapper* mapper, bool ownShadows)
  : Mapper(mapper)
{
  if (!mapper)
  {
    return;
  }
  this->SampleDistance = mapper->GetSampleDistance();
  this->ShadowSampleDistance = mapper->GetShadowSampleDistance();
  this->Technique = mapper->GetShadowTechnique();
  this->Resolution = mapper->GetShadowResolution();
  mapper->SetSampleDistance(static_cast<float>(LongerSteps * this->SampleDistance));
  if (ownShadows)
  {
    mapper->SetShadowSampleDistance(LongerSteps * this->ShadowSampleDistance);
    mapper->SetShadowTechniqueToOpacityMap();
    mapper->SetShadowResolution(std::min(
      this->Resolution, ResolutionOfMaps(vtkImageData::SafeDownCast(mapper->GetDataSetInput()))));
  }
}

//------------------------------------------------------------------------------
MovingSettings::~MovingSettings()
{
  if (this->Mapper)
  {
    this->Mapper->SetSampleDistance(this->SampleDistance);
    this->Mapper->SetShadowSampleDistance(this->ShadowSampleDistance);
    this->Mapper->SetShadowTechnique(this->Technique);
    this->Mapper->SetShadowResolution(this->Resolution);
  }
}

}
