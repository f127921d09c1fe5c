/**
 * @file    TakenOver.h
 * @brief   which scenes the illuminated mapper draws itself
 */

#ifndef TakenOver_h
#define TakenOver_h

#include <string>

class vtkDataArray;
class vtkGPUVolumeRayCastMapper;
class vtkRenderer;
class vtkVolume;

namespace penumbra
{

/// Empty where the illuminated mapper draws the volume itself; else what of the scene it leaves to
/// the stock ray caster, as the beginning of a sentence. scalars: the array that the mapper draws.
std::string FindWhatIsNotTakenOver(vtkGPUVolumeRayCastMapper* mapper, vtkDataArray* scalars,
  bool cellData, vtkRenderer* renderer, vtkVolume* volume);

}

#endif
