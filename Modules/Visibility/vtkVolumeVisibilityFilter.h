/**
 * @class   vtkVolumeVisibilityFilter
 * @brief   how much of each light reaches each point of a volume
 *
 * The input is a volume of one point scalar a voxel, the output an image in the same box with the
 * visibility of every light that casts a shadow, as a vtkVolumeLight defines it: along the shadow
 * ray, which begins ShadowBias away from the point and ends at the light or where it leaves the
 * volume,
 *
 *   soft  V = exp(-tau), tau = integral of the extinction s
 *   hard  V = 0 where 1 - exp(-tau) exceeds OpacityThreshold, else 1
 *
 * with s = -g ln(1 - a) / D of the opacity a per unit distance D and the gradient opacity g of the
 * volume's property (a at most 1 - 2^-24). What clipping planes, cropping and the mask (input port
 * 1) hide casts no shadow; V is defined at hidden points too. The ray is cut into steps, the last
 * shorter, and sampled in their middle: V converges with second order in SampleDistance. Empty
 * space is left out without changing V. Lengths that belong to the matter are in the volume's own
 * coordinates, before the actor's matrix; lights and clipping planes are in the world.
 *
 * Each light gives one float array of point data, called "Visibility", its index among the lights,
 * and its kind: Visibility0Directional, Visibility2Point, Visibility3Spot, Visibility4Headlight.
 * The first is the active scalars. Lights that are off or cast no shadow are counted but have no
 * array. For a texture PackArrays makes a single array with one component a light instead.
 *
 * NaN and -Inf count as the smallest finite value of the volume, +Inf as the largest, with a
 * warning. What cannot be computed is an error of one line and gives an empty output; so does
 * AbortExecute, which is honoured after each small batch of points. Progress and abortion are the
 * calling thread's alone. Work is shared by vtkSMPTools; the number of threads changes no bit.
 *
 * @sa vtkVolumeLight vtkIlluminatedVolumeMapper
 */

#ifndef vtkVolumeVisibilityFilter_h
#define vtkVolumeVisibilityFilter_h

#include "PenumbraVisibilityModule.h" // For export macro
#include "vtkImageAlgorithm.h"

class vtkLight;
class vtkLightCollection;
class vtkMatrix4x4;
class vtkPlane;
class vtkPlaneCollection;
class vtkVolumeProperty;

namespace penumbra
{
struct VisibilityScene;
}

class PENUMBRAVISIBILITY_EXPORT vtkVolumeVisibilityFilter : public vtkImageAlgorithm
{
public:
  static vtkVolumeVisibilityFilter* New();
  vtkTypeMacro(vtkVolumeVisibilityFilter, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The volume's property: scalar opacity and its unit distance, gradient opacity and the type of
   * interpolation of its first component. Default: none, which is an error.
   */
  virtual void SetVolumeProperty(vtkVolumeProperty* property);
  vtkGetObjectMacro(VolumeProperty, vtkVolumeProperty);
  ///@}

  ///@{
  /**
   * The lights, such as a renderer's. Null for none. Default: none, which is an error.
   */
  virtual void SetLights(vtkLightCollection* lights);
  vtkGetObjectMacro(Lights, vtkLightCollection);
  void AddLight(vtkLight* light);
  void RemoveAllLights();
  ///@}

  ///@{
  /**
   * Direction of travel of a headlight, in the world: the camera's direction of projection.
   * Default: (0, 0, -1), that of a new vtkCamera.
   */
  vtkSetVector3Macro(CameraDirection, double);
  vtkGetVector3Macro(CameraDirection, double);
  ///@}

  ///@{
  /**
   * The actor's matrix, from the volume's own coordinates to the world: what vtkVolume::GetMatrix()
   * gives. Default: none, the identity.
   */
  virtual void SetMatrix(vtkMatrix4x4* matrix);
  vtkGetObjectMacro(Matrix, vtkMatrix4x4);
  ///@}

  ///@{
  /**
   * Planes in the world that hide what is on their negative side. Null for none. Default: none.
   */
  virtual void SetClippingPlanes(vtkPlaneCollection* planes);
  vtkGetObjectMacro(ClippingPlanes, vtkPlaneCollection);
  void AddClippingPlane(vtkPlane* plane);
  void RemoveAllClippingPlanes();
  ///@}

  ///@{
  /**
   * Whether everything is hidden outside of an interval of origin + index * spacing along each
   * axis: xmin, xmax, ymin, ymax, zmin, zmax. Default: off, and 0 to 1.
   */
  vtkSetMacro(Cropping, bool);
  vtkGetMacro(Cropping, bool);
  vtkBooleanMacro(Cropping, bool);
  vtkSetVector6Macro(CroppingRegionPlanes, double);
  vtkGetVector6Macro(CroppingRegionPlanes, double);
  ///@}

  ///@{
  /**
   * A mask with the volume's dimensions. Matter is hidden where the nearest voxel of the mask is 0.
   * Default: none.
   */
  void SetMaskConnection(vtkAlgorithmOutput* mask) { this->SetInputConnection(1, mask); }
  void SetMaskData(vtkImageData* mask);
  ///@}

  /// The values are those of penumbra::GradientEstimator.
  enum GradientEstimatorType
  {
    CentralDifferences = 0,
    ForwardDifferences = 1,
    BackwardDifferences = 2,
    Sobel = 3
  };

  ///@{
  /**
   * How the gradient is estimated for gradient opacity. Twelve bytes a voxel are needed meanwhile.
   * Default: CentralDifferences.
   */
  vtkSetClampMacro(GradientEstimator, int, CentralDifferences, Sobel);
  vtkGetMacro(GradientEstimator, int);
  ///@}

  ///@{
  /**
   * Length of a step in the volume's own coordinates. 0, anything below, NaN: half the smallest
   * voxel spacing. Default: 0. Rays of more than 2^24 steps are an error.
   */
  vtkSetMacro(SampleDistance, double);
  vtkGetMacro(SampleDistance, double);
  ///@}

  ///@{
  /**
   * Points of the output per voxel along each axis, 1/64 to 16. The first and the last point along
   * an axis stay where the first and the last voxel are. Default: 1.
   */
  vtkSetClampMacro(Resolution, double, 0.015625, 16.0);
  vtkGetMacro(Resolution, double);
  ///@}

  ///@{
  /**
   * Numbers of points of the output along each axis, where above 0 instead of what Resolution
   * gives. Default: 0, 0, 0.
   */
  vtkSetVector3Macro(OutputDimensions, int);
  vtkGetVector3Macro(OutputDimensions, int);
  ///@}

  ///@{
  /**
   * A soft shadow that leaves less of the light than this is complete: V is 0, and its ray ends
   * there. 0 to 0.1. Default: 1/4096, a sixteenth of a step of 8 bits.
   */
  vtkSetClampMacro(NegligibleVisibility, double, 0.0, 0.1);
  vtkGetMacro(NegligibleVisibility, double);
  ///@}

  ///@{
  /**
   * Whether the output is a single array, "Visibility", with one component for each light that
   * casts a shadow, named as its own array would be. Up to four lights are the texels of a texture
   * as they are. Default: off.
   */
  vtkSetMacro(PackArrays, bool);
  vtkGetMacro(PackArrays, bool);
  vtkBooleanMacro(PackArrays, bool);
  ///@}

  /**
   * With those of the property, its functions, the lights, the matrix and the clipping planes.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkVolumeVisibilityFilter();
  ~vtkVolumeVisibilityFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  vtkVolumeProperty* VolumeProperty = nullptr;
  vtkLightCollection* Lights = nullptr;
  double CameraDirection[3] = { 0.0, 0.0, -1.0 };
  vtkMatrix4x4* Matrix = nullptr;
  vtkPlaneCollection* ClippingPlanes = nullptr;
  bool Cropping = false;
  double CroppingRegionPlanes[6] = { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 };
  int GradientEstimator = CentralDifferences;
  double SampleDistance = 0.0;
  double Resolution = 1.0;
  int OutputDimensions[3] = { 0, 0, 0 };
  double NegligibleVisibility = 1.0 / 4096.0;
  bool PackArrays = false;

private:
  vtkVolumeVisibilityFilter(const vtkVolumeVisibilityFilter&) = delete;
  void operator=(const vtkVolumeVisibilityFilter&) = delete;

  penumbra::VisibilityScene GetScene(vtkInformationVector** inputs);
  bool IsAborted();
};

#endif
