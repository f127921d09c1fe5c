/**
 * @class   vtkIlluminatedVolumeMapper
 * @brief   VTK's GPU volume ray caster with light and shadow
 *
 * A drop-in for vtkGPUVolumeRayCastMapper: put it where the stock mapper stood. Volume, transfer
 * functions, material, lights, camera, cropping, clipping planes and binary mask are taken from
 * where VTK keeps them. A vtkLight lights the volume without a shadow, a vtkVolumeLight with the
 * shadow it asks for.
 *
 * Light is absorbed, emitted and scattered once (Max 1995), with the reflection of the volume's
 * property (Phong's, or what a vtkVolumeMaterial says) at normals against the scalar's gradient:
 *
 *   L = integral of s(t) c(t) T(0,t) dt,  T(0,t) = exp(-integral of s),  alpha = 1 - T
 *   c = C ka sum(Ia) + sum over lights of att spot V (C kd Id F_d + ks Is F_s)
 *
 * with the extinction s = -ln(1 - opacity) / ScalarOpacityUnitDistance and the visibility V of each
 * light (see vtkVolumeLight). View rays and shadow rays are cut into steps whose samples lie in
 * their middle; the last step has its true length. There is no jitter, and no step length depends
 * on a clock: the same scene gives the same picture. (While a window asks for an update rate there
 * are fewer rays, see GetActualImageSampleDistance().)
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
 * maps, two-dimensional transfer functions, clipped voxel intensity, blanking, cell data,
 * rectilinear grids, multi-volume, render to image, the depth pass, final colour window and level,
 * picking, depth peeling of volumes) it leaves to its superclass, and says so once.
 *
 * What cannot be drawn (a matrix or a projection without an inverse, a volume that the graphics
 * card cannot hold, a program that does not build) is an error of one line through vtkErrorMacro,
 * and that volume is not drawn. What is drawn otherwise than asked is told by GetMessages().
 *
 * @sa vtkVolumeLight vtkVolumeMaterial
 */

#ifndef vtkIlluminatedVolumeMapper_h
#define vtkIlluminatedVolumeMapper_h

#include "LightingRequirements.h"    // For LightingRequirements
#include "PenumbraRenderingModule.h" // For export macro
#include "vtkOpenGLGPUVolumeRayCastMapper.h"

#include <cstddef> // For std::size_t
#include <memory>  // For std::unique_ptr
#include <string>  // For std::string
#include <vector>  // For std::vector

class vtkDataArray;
class vtkOpenGLRenderWindow;

namespace penumbra
{
struct PictureRequest;
}

class PENUMBRARENDERING_EXPORT vtkIlluminatedVolumeMapper : public vtkOpenGLGPUVolumeRayCastMapper
{
public:
  static vtkIlluminatedVolumeMapper* New();
  vtkTypeMacro(vtkIlluminatedVolumeMapper, vtkOpenGLGPUVolumeRayCastMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ShadowTechniqueType
  {
    Auto = 0,
    Rays = 1,
    Volume = 2,
    Map = 3,
    DeepMap = 4,
    OpacityMap = 5
  };

  /// The values are those of penumbra::GradientEstimator.
  enum GradientEstimatorType
  {
    CentralDifferences = 0,
    ForwardDifferences = 1,
    BackwardDifferences = 2,
    Sobel = 3
  };

  enum OpticalModelType
  {
    ByShade = 0,
    Absorption = 1,
    Emission = 2,
    AbsorptionEmission = 3,
    SingleScattering = 4
  };

  ///@{
  /**
   * How shadows are computed. Rays marches a ray towards each shadowed light from every sample that
   * the light can brighten; it is the definition of the shadow. Volume marches them beforehand over
   * the whole volume, where they are kept until the light, the opacity or what is hidden changes,
   * and looks them up. DeepMap keeps, for each light, how dark it grows along its rays, as a
   * function of eight nodes a texel (Lokovic and Veach 2000), which takes the least memory;
   * OpacityMap keeps that at even distances, layer by layer (Kim and Neumann 2001), which is looked
   * up fastest; Map, for hard shadows, where these rays are first hidden, and filters the shadows'
   * edges. Auto takes the cheapest of all but Map whose predicted error is within ShadowTolerance;
   * it depends on the scene alone, never on a clock. Default: Auto.
   */
  vtkSetClampMacro(ShadowTechnique, int, Auto, OpacityMap);
  vtkGetMacro(ShadowTechnique, int);
  void SetShadowTechniqueToAuto() { this->SetShadowTechnique(Auto); }
  void SetShadowTechniqueToRays() { this->SetShadowTechnique(Rays); }
  void SetShadowTechniqueToVolume() { this->SetShadowTechnique(Volume); }
  void SetShadowTechniqueToMap() { this->SetShadowTechnique(Map); }
  void SetShadowTechniqueToDeepMap() { this->SetShadowTechnique(DeepMap); }
  void SetShadowTechniqueToOpacityMap() { this->SetShadowTechnique(OpacityMap); }
  ///@}

  ///@{
  /**
   * Root mean square error of the picture, in grey levels of 255, that Auto may accept. Range: 0 to
   * 255. Default: 1.
   */
  vtkSetClampMacro(ShadowTolerance, double, 0.0, 255.0);
  vtkGetMacro(ShadowTolerance, double);
  ///@}

  /**
   * Why the last Render() took its shadow technique: one clause.
   */
  const std::string& GetShadowTechniqueReason() const;

  ///@{
  /**
   * Texels of kept shadows to a smallest voxel edge. Where slices lie farther apart, a volume has
   * up to two texels from slice to slice. It falls where the memory limit or OpenGL's largest
   * texture ask for it, and a message says so; while a light moves in pictures that adjust to an
   * update rate it is halved, until all is still. Range: 0.001 to 16. Default: 1.
   */
  vtkSetClampMacro(ShadowResolution, double, 1e-3, 16.0);
  vtkGetMacro(ShadowResolution, double);
  ///@}

  ///@{
  /**
   * With kept shadows, the first steps of a sample's shadow ray are marched and what is kept counts
   * beyond them only: matter changes fastest where the sample is. Auto chooses, and chooses a
   * resolution that may be below ShadowResolution too. Range: 0 to 1024. Default: 4.
   */
  vtkSetClampMacro(ShadowNearSteps, int, 0, 1024);
  vtkGetMacro(ShadowNearSteps, int);
  ///@}

  ///@{
  /**
   * Memory that kept shadows may take on the graphics card, in MiB. Range: 1 or more. Default: 512.
   */
  vtkSetClampMacro(ShadowMemoryLimit, int, 1, VTK_INT_MAX);
  vtkGetMacro(ShadowMemoryLimit, int);
  ///@}

  ///@{
  /**
   * About how many seconds of a Render() may go into shadows that are kept; 0: as many as it takes.
   * Where they do not suffice, the volume is not drawn, and the next Render() goes on: for programs
   * that answer events in between. Range: 0 to 1e30. Default: 0.
   */
  vtkSetClampMacro(ShadowUpdateTime, double, 0.0, 1e30);
  vtkGetMacro(ShadowUpdateTime, double);
  ///@}

  /**
   * Whether the last Render() had all shadows that are kept, and so drew the volume.
   */
  bool GetShadowsComplete() const;

  ///@{
  /**
   * What is kept of shadows after the last Render(): bytes, texels a voxel, steps marched, how many
   * lights were computed since this mapper was made, and the seconds that the last computation of
   * any took. 0 where nothing is kept.
   */
  std::size_t GetShadowBytes() const;
  double GetActualShadowResolution() const;
  int GetActualShadowNearSteps() const;
  int GetNumberOfShadowUpdates() const;
  double GetShadowUpdateSeconds() const;
  ///@}

  ///@{
  /**
   * Length of a shadow ray's step in the volume's own coordinates. What is no length (0 or less,
   * NaN, 1e30 or more): twice the sample distance of the view rays. Default: 0.
   *
   * The view rays' step is SampleDistance, inherited; here what is no length, as 0, the default,
   * stands for half the smallest voxel spacing.
   */
  vtkSetMacro(ShadowSampleDistance, double);
  vtkGetMacro(ShadowSampleDistance, double);
  ///@}

  ///@{
  /**
   * How the gradient of the scalar field is estimated, from interpolated values one voxel away:
   * CentralDifferences from both sides of each axis, ForwardDifferences and BackwardDifferences
   * from one, Sobel from the 26 neighbours with weights of 1, 3 and 6, which smooths noise and
   * costs most. It counts for normals and for gradient opacity. Default: CentralDifferences.
   */
  vtkSetClampMacro(GradientEstimator, int, CentralDifferences, Sobel);
  vtkGetMacro(GradientEstimator, int);
  void SetGradientEstimatorToCentralDifferences()
  {
    this->SetGradientEstimator(CentralDifferences);
  }
  void SetGradientEstimatorToForwardDifferences()
  {
    this->SetGradientEstimator(ForwardDifferences);
  }
  void SetGradientEstimatorToBackwardDifferences()
  {
    this->SetGradientEstimator(BackwardDifferences);
  }
  void SetGradientEstimatorToSobel() { this->SetGradientEstimator(Sobel); }
  ///@}

  /// A number of bits: 16 where they hold the gradients exactly, in no more than 128 MiB; else 0.
  static constexpr int AutomaticGradientTexture = -1;

  ///@{
  /**
   * Where not 0, gradients are estimated once per volume and kept in a texture of that many bits a
   * component, 8 or 16, three components a voxel. Interpolating them is the same as estimating at
   * each sample, up to their rounding, see GetGradientTextureLargestError(); 16 bits are exact
   * where scalars are integers whose range is below 32768, for Sobel below 1490. A lit frame takes
   * up to a fifth less time with them, the first one more. Values in between count as the next
   * larger ones. Default: AutomaticGradientTexture.
   */
  void SetGradientTextureBits(int bits);
  vtkGetMacro(GradientTextureBits, int);
  ///@}

  /// The bits of the gradients that the last Render() kept; 0 where it kept none.
  int GetActualGradientTextureBits() const;

  ///@{
  /**
   * Whether rays leap over bricks of the volume without visible matter. The picture is the same: no
   * sample that is left moves. It is left out by itself where too little is empty for it to help.
   * Default: on.
   */
  vtkSetMacro(SkipEmptySpace, bool);
  vtkGetMacro(SkipEmptySpace, bool);
  vtkBooleanMacro(SkipEmptySpace, bool);
  ///@}

  ///@{
  /**
   * Bricks that the last Render() cut the volume into, cubes of BrickEdge cells, and how many of
   * them may hold visible matter. 0 where SkipEmptySpace is off.
   */
  int GetNumberOfBricks() const;
  int GetNumberOfOccupiedBricks() const;
  int GetBrickEdge() const;
  ///@}

  /**
   * How dense the visible matter of the last Render() was: the optical depth of the smallest
   * spacing in the densest matter of a brick, on average over the occupied bricks. By it Auto
   * predicts errors.
   */
  double GetMeanVoxelDepth() const;

  ///@{
  /**
   * What keeping gradients costs: bytes of the texture, largest error of a component in scalar
   * units per voxel, and mean error of the direction in degrees, weighted by the gradient's
   * magnitude. 0 where the last Render() kept none.
   */
  std::size_t GetGradientTextureBytes() const;
  double GetGradientTextureLargestError() const;
  double GetGradientTextureAngularError() const;
  ///@}

  ///@{
  /**
   * What matter does with light (Max 1995), T the transmittance, s the extinction, C the colour:
   *
   * - Absorption: L = background T.
   * - Emission: L = background + integral of s C, alpha 0.
   * - AbsorptionEmission: L = integral of s C T(0,t) + background T.
   * - SingleScattering: the same with C lit, the sum at the top.
   *
   * ByShade: SingleScattering where the property's Shade is on, else AbsorptionEmission. Default:
   * ByShade.
   */
  vtkSetClampMacro(OpticalModel, int, ByShade, SingleScattering);
  vtkGetMacro(OpticalModel, int);
  void SetOpticalModelToByShade() { this->SetOpticalModel(ByShade); }
  void SetOpticalModelToAbsorption() { this->SetOpticalModel(Absorption); }
  void SetOpticalModelToEmission() { this->SetOpticalModel(Emission); }
  void SetOpticalModelToAbsorptionEmission() { this->SetOpticalModel(AbsorptionEmission); }
  void SetOpticalModelToSingleScattering() { this->SetOpticalModel(SingleScattering); }
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
   * Distance between the rays of the last Render(), in pixels of the window. Where
   * AutoAdjustSampleDistances, inherited, is on, a window that asks for an update rate gets as many
   * rays as fit into the frame's time by the measure of the frame before; a still has them all,
   * ImageSampleDistance apart. No step along a ray changes, so moving and still pictures are
   * equally bright. Default: on, as with the stock mapper.
   */
  double GetActualImageSampleDistance() const;

  /**
   * Number of draws that the last Render() was cut into, so that no fragment exceeds the number of
   * loop iterations that a driver may stop at. The picture does not depend on it.
   */
  int GetNumberOfDraws() const;

  ///@{
  /**
   * Whether Render() draws every picture once more, out of sight, to count what its rays do. For
   * studies of what pictures cost: it takes as long as the picture. Default: off.
   */
  vtkSetMacro(RayCounting, bool);
  vtkGetMacro(RayCounting, bool);
  vtkBooleanMacro(RayCounting, bool);
  ///@}

  ///@{
  /**
   * What the rays of the last Render() did, over all pixels: samples of view rays, with matter or
   * without; those of them whose light was computed; steps of shadow rays from there, not of what
   * is kept of shadows. 0 where RayCounting is off, and where the stock ray caster drew.
   */
  double GetNumberOfSamples() const;
  double GetNumberOfShadedSamples() const;
  double GetNumberOfShadowSteps() const;
  ///@}

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
  void MoveTo(vtkOpenGLRenderWindow* window);
  void DrawInTime(const penumbra::PictureRequest& request);
  void Draw(vtkRenderer* renderer);
  void CountRays(vtkRenderer* renderer);
  void Say(const std::string& message);

  int ShadowTechnique = Auto;
  double ShadowSampleDistance = 0.0;
  double ShadowTolerance = 1.0;
  double ShadowResolution = 1.0;
  int ShadowNearSteps = 4;
  int ShadowMemoryLimit = 512;
  double ShadowUpdateTime = 0.0;
  int GradientEstimator = CentralDifferences;
  int GradientTextureBits = AutomaticGradientTexture;
  int OpticalModel = ByShade;
  bool SkipEmptySpace = true;
  bool RayCounting = false;

private:
  vtkIlluminatedVolumeMapper(const vtkIlluminatedVolumeMapper&) = delete;
  void operator=(const vtkIlluminatedVolumeMapper&) = delete;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
