/**
 * @file    ReferenceIntegrator.h
 * @brief   a scene's picture by the lighting model, in double precision, with a bound on its error
 *
 * For pictures that others are measured by. Per pixel, in the middle of which its view ray goes,
 *
 *   L = integral of s(t) c(t) T(0,t) dt,  T(0,t) = exp(-integral of s),  alpha = 1 - T
 *
 * over the background, with the extinction s and the shaded colour c as vtkIlluminatedVolumeMapper
 * documents them; the visibility of each light is the integral along a shadow ray from each sample.
 *
 * View rays and shadow rays are cut exactly where their integrands are not smooth: at cells' faces,
 * where the scalar field crosses a point of a transfer function, where a surface turns its side,
 * at the borders of what is hidden. Between, Gauss's rule with 3 nodes and Kronrod's with 7 bound
 * each other's errors, and what exceeds its share of the tolerance is halved. There is no step
 * length. The picture depends on scene and options alone, not on the number of threads.
 */

#ifndef ReferenceIntegrator_h
#define ReferenceIntegrator_h

#include "PenumbraReferenceModule.h" // For export macro
#include "ReferenceScene.h"

#include "vtkType.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace penumbra
{

struct ReferenceOptions
{
  /// Largest error of a pixel's channels, in grey levels of 255; more than 0. Default: 0.05.
  double Tolerance = 0.05;
  /// A pixel that needs more samples of the shaded colour is given up; more than 0. Default: 20000.
  int MostSamplesPerPixel = 20000;
  /// Told how much is done, 0 to 1, by the thread that renders; returns whether to go on. Empty:
  /// nobody is told.
  std::function<bool(double)> Progress;
};

struct ReferencePixel
{
  /// Red, green and blue over the background, and alpha.
  std::array<double, 4> Color{};
  /// Bound on the error of any of them, in grey levels of 255.
  double Error = 0.0;
  /// Whether it is within the tolerance.
  bool Converged = true;
  int Samples = 0;
  int ShadowRays = 0;
};

struct ReferenceStatistics
{
  /// Over the pixels' error bounds, in grey levels of 255.
  double LargestError = 0.0;
  double RootMeanSquareError = 0.0;
  vtkIdType PixelsNotConverged = 0;
  vtkIdType Samples = 0;
  vtkIdType ShadowRays = 0;
};

struct ReferencePicture
{
  /// Red, green, blue and alpha, the bottom row first; of type float.
  vtkSmartPointer<vtkImageData> Colors;
  /// Bound on each pixel's error in grey levels of 255, of type float.
  vtkSmartPointer<vtkImageData> Errors;
  ReferenceStatistics Statistics;
};

class PENUMBRAREFERENCE_EXPORT ReferenceIntegrator
{
public:
  /// Takes the scene as it is now; later changes of its parts may count or not.
  /// @throw std::invalid_argument where a part is missing or parts do not go together, in one line.
  explicit ReferenceIntegrator(const ReferenceScene& scene, const ReferenceOptions& options = {});
  ~ReferenceIntegrator();
  ReferenceIntegrator(const ReferenceIntegrator&) = delete;
  ReferenceIntegrator& operator=(const ReferenceIntegrator&) = delete;

  /// At a point of the picture in pixels from its lower left corner; the middle of the first pixel
  /// is (0.5, 0.5). May be called from several threads at once.
  ReferencePixel ComputePixel(double x, double y) const;

  /// By all threads of vtkSMPTools. Empty where the progress function said to stop.
  std::optional<ReferencePicture> Render() const;

  /// What a user should know of the scene, one sentence each.
  const std::vector<std::string>& GetWarnings() const;

private:
  class Internals;
  std::unique_ptr<Internals> Internal;
};

}

#endif
