/**
 * @class   vtkVolumeLight
 * @brief   a light that can cast shadows inside volumes
 *
 * A vtkLight with a shadow state of its own, for volumes drawn by vtkIlluminatedVolumeMapper. Add
 * it to the renderer like any light. What vtkLight defines keeps its meaning: headlight, camera and
 * scene lights, position and focal point, colours, intensity, attenuation, cone and exponent. Other
 * props see it as a plain vtkLight.
 *
 * From a sample towards the light a shadow ray starts ShadowBias away and ends where it leaves the
 * volume or reaches the light. Along it the visibility V of the light is
 *
 * - None: V = 1.
 * - Soft, for semi-transparent occluders: V = exp(-tau), tau the integral of the extinction.
 * - Hard, for opaque occluders: V = 0 as soon as the accumulated opacity 1 - exp(-tau) exceeds
 *   OpacityThreshold, else V = 1.
 *
 * V dims the diffuse and the specular term, never the ambient one. The ambient colour defaults to
 * white, unlike vtkLight's black, so that Phong's ambient term takes part.
 *
 * @sa vtkIlluminatedVolumeMapper
 */

#ifndef vtkVolumeLight_h
#define vtkVolumeLight_h

#include "PenumbraLightingModule.h" // For export macro
#include "vtkLight.h"

class PENUMBRALIGHTING_EXPORT vtkVolumeLight : public vtkLight
{
public:
  static vtkVolumeLight* New();
  vtkTypeMacro(vtkVolumeLight, vtkLight);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ShadowType
  {
    None = 0,
    Soft = 1,
    Hard = 2
  };

  ///@{
  /**
   * How matter between a sample and this light dims it: None, Soft or Hard. Default: None.
   */
  vtkSetClampMacro(Shadow, int, None, Hard);
  vtkGetMacro(Shadow, int);
  void SetShadowToNone() { this->SetShadow(None); }
  void SetShadowToSoft() { this->SetShadow(Soft); }
  void SetShadowToHard() { this->SetShadow(Hard); }
  const char* GetShadowAsString();
  ///@}

  ///@{
  /**
   * Accumulated opacity beyond which a hard shadow is complete, 0 to 1. Default: 0.95. Taken as at
   * most 1 - 2^-24, the largest opacity that matter can have.
   */
  vtkSetClampMacro(OpacityThreshold, double, 0.0, 1.0);
  vtkGetMacro(OpacityThreshold, double);
  ///@}

  ///@{
  /**
   * Distance between a sample and the start of its shadow ray, in the volume's own lengths (before
   * the actor's matrix). It keeps matter from shadowing itself. Any negative value stands for the
   * smallest voxel spacing of the volume. Default: -1.
   */
  vtkSetMacro(ShadowBias, double);
  vtkGetMacro(ShadowBias, double);
  ///@}

  /**
   * Takes over all of another light's state; of a plain vtkLight's, what it has.
   */
  void DeepCopy(vtkLight* light);

  /**
   * A new light of this class with all of this one's state; used by VTK to copy lights.
   */
  vtkLight* ShallowClone() override;

protected:
  vtkVolumeLight();
  ~vtkVolumeLight() override;

  int Shadow = None;
  double OpacityThreshold = 0.95;
  double ShadowBias = -1.0;

private:
  vtkVolumeLight(const vtkVolumeLight&) = delete;
  void operator=(const vtkVolumeLight&) = delete;
};

#endif
