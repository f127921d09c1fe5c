/**
 * @class   vtkIlluminatedVolumeMapper
 * @brief   VTK's GPU volume ray caster with light and shadow
 *
 * A drop-in for vtkGPUVolumeRayCastMapper: put it where the stock mapper stood. Volume, transfer
 * functions, material, lights, camera, cropping, clipping planes and binary mask are taken from
 * where VTK keeps them. A vtkLight lights the volume without a shadow, a vtkVolumeLight with the
 * shadow it asks for.
 *
 * Light is absorbed, emitted and scattered once (Max 1995), with Phong's reflection (Phong 1975) at
 * normals by central differences:
 *
 *   L = integral of s(t) c(t) T(0,t) dt,  T(0,t) = exp(-integral of s),  alpha = 1 - T
 *   c = C ka sum(Ia) + sum over lights of att spot V (C kd Id F_d + ks Is F_s)
 *
 * with the extinction s = -ln(1 - opacity) / ScalarOpacityUnitDistance and the visibility V of each
 * light (see vtkVolumeLight). View rays and shadow rays are cut into steps whose samples lie in
 * their middle; the last step has its true length. There is no jitter, and no step length depends
 * on a clock: the same scene gives the same picture.
 *
 * Lengths that belong to the matter (unit distance, sample distances, shadow bias) are measured in
 * the volume's own coordinates, before the actor's matrix. Lights, camera and clipping planes are
 * in the world. What cropping, clipping planes and a mask hide casts no shadow.
 *
 * How it works: the stock ray caster draws a box that stands for the volume, and a render pass
 * replaces its GLSL by this module's own, chosen by LightingRequirements. Scenes of equal
 * requirements share one program.
 *
 * What this mapper does not take over (blend modes other than composite, several components, label
 * maps, two-dimensional transfer functions, blanking, cell data, rectilinear grids, multi-volume,
 * render to image, picking, depth peeling of volumes) it leaves to its superclass, and says so
 * once.
 *
 * @sa vtkVolumeLight
 */

#ifndef vtkIlluminatedVolumeMapper_h
#define vtkIlluminatedVolumeMapper_h

#include "LightingRequirements.h"    // For LightingRequirements
#include "PenumbraRenderingModule.h" // For export macro
#include "vtkOpenGLGPUVolumeRayCastMapper.h"

#include <memory> // For std::unique_ptr
#include <string> // For std::string
#include <vector> // For std::vector

class vtkDataArray;
class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkVolumeProperty;

class PENUMBRARENDERING_EXPORT vtkIlluminatedVolumeMapper : public vtkOpenGLGPUVolumeRayCastMapper
{
public:
  static vtkIlluminatedVolumeMapper* New();
  vtkTypeMacro(vtkIlluminatedVolumeMapper, vtkOpenGLGPUVolumeRayCastMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ShadowTechniqueType
  {
    Auto = 0,
    Rays = 1
  };

  ///@{
  /**
   * How shadows are computed. Rays marches a ray towards each shadowed light from every sample that
   * the light can brighten; it is the definition of the shadow. Auto chooses; for now it is Rays.
   * Default: Auto.
   */
  vtkSetClampMacro(ShadowTechnique, int, Auto, Rays);
  vtkGetMacro(ShadowTechnique, int);
  void SetShadowTechniqueToAuto() { this->SetShadowTechnique(Auto); }
  void SetShadowTechniqueToRays() { this->SetShadowTechnique(Rays); }
  ///@}

  ///@{
  /**
   * Length of a shadow ray's step in the volume's own coordinates. 0 or less: twice the sample
   * distance of the view rays. Default: 0.
   *
   * The view rays' step is SampleDistance, inherited; here 0 or less, the default, stands for half
   * the smallest voxel spacing, and AutoAdjustSampleDistances has no effect.
   */
  vtkSetMacro(ShadowSampleDistance, double);
  vtkGetMacro(ShadowSampleDistance, double);
  ///@}

  /**
   * What the scene of the last Render() needed, and so what its program consists of.
   */
  const penumbra::LightingRequirements& GetRequirements() const;

  /**
   * Steps in use by the last Render(), with every default resolved, in the volume's own
   * coordinates.
   */
  double GetActualSampleDistance() const;
  double GetActualShadowSampleDistance() const;

  /**
   * Number of draws that the last Render() was cut into, so that no fragment exceeds the number of
   * loop iterations that a driver may stop at. The picture does not depend on it.
   */
  int GetNumberOfDraws() const;

  /**
   * Number of times that a shader program was built since this mapper was made. It grows when the
   * requirements change, not when a light moves or changes its colour.
   */
  int GetNumberOfShaderBuilds() const;

  /**
   * The fragment shader of the last program that was built. Empty before the first Render().
   */
  const std::string& GetFragmentShaderSource() const;

  /**
   * What the last Render() had to say: replaced voxels, coarser steps, features left to the
   * superclass. One sentence each; each is also given once through vtkWarningMacro.
   */
  const std::vector<std::string>& GetMessages() const;

  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkIlluminatedVolumeMapper();
  ~vtkIlluminatedVolumeMapper() override;

  void GPURender(vtkRenderer* renderer, vtkVolume* volume) override;

  void DrawIlluminated(vtkRenderer* renderer, vtkVolume* volume, vtkDataArray* scalars);
  void DrawStock(vtkRenderer* renderer, vtkVolume* volume);
  double GetSampleDistanceOrDefault();
  void MoveTo(vtkOpenGLRenderWindow* window);
  bool PrepareGeometry(vtkRenderer* renderer, vtkVolume* volume, vtkImageData* image);
  void PrepareVisibility(vtkImageData* image);
  bool PrepareTextures(vtkOpenGLRenderWindow* window, vtkVolumeProperty* property,
    vtkImageData* image, vtkDataArray* scalars);
  void PrepareLights(vtkRenderer* renderer, vtkVolumeProperty* property);
  void PlanDraws();
  void Draw(vtkRenderer* renderer);
  vtkImageData* GetUsableMask(vtkImageData* image);
  void Say(const std::string& message);

  int ShadowTechnique = Auto;
  double ShadowSampleDistance = 0.0;

private:
  vtkIlluminatedVolumeMapper(const vtkIlluminatedVolumeMapper&) = delete;
  void operator=(const vtkIlluminatedVolumeMapper&) = delete;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
