#include "ReferenceIntegrator.h"

#include "PictureRays.h"
#include "RadianceIntegral.h"
#include "RenderingModel.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace penumbra
{
using namespace reference;

namespace
{
constexpr double GreyLevels = 255.0;

// Each time so many parts of the picture are done, the progress is told.
constexpr vtkIdType ProgressParts = 100;
constexpr vtkIdType PixelsAtOnce = 8;

void Check(bool condition, const char* otherwise)
{
  if (!condition)
  {
    throw std::invalid_argument(otherwise);
  }
}

bool HasVoxels(vtkImageData* image)
{
  return image && image->GetNumberOfPoints() > 0 && image->GetPointData()->GetScalars() &&
    image->GetPointData()->GetScalars()->GetNumberOfTuples() == image->GetNumberOfPoints();
}

const ReferenceScene& Check(const ReferenceScene& scene, const ReferenceOptions& options)
{
  Check(HasVoxels(scene.Volume), "the volume has no point scalars");
  Check(scene.Property != nullptr, "there is no volume property");
  Check(scene.Camera != nullptr, "there is no camera");
  Check(scene.Size[0] > 0 && scene.Size[1] > 0, "the picture has no pixels");
  Check(options.Tolerance > 0.0, "the tolerance is not more than 0");
  Check(options.MostSamplesPerPixel > 0, "the most samples per pixel are not more than 0");
  if (scene.Mask)
  {
    int dimensions[3];
    int ofMask[3];
    scene.Volume->GetDimensions(dimensions);
    scene.Mask->GetDimensions(ofMask);
    Check(HasVoxels(scene.Mask) && std::equal(dimensions, dimensions + 3, ofMask),
      "the mask has not the volume's dimensions");
  }
  return scene;
}

/// Nothing absorbs it, so that it may exceed white by far; how far does not matter.
void ClampEmission(ReferencePixel& pixel)
{
  double error = 0.0;
  for (int channel = 0; channel < 3; ++channel)
  {
    double& color = pixel.Color[channel];
    const double high = std::clamp(color + pixel.Error, 0.0, 1.0);
    const double low = std::clamp(color - pixel.Error, 0.0, 1.0);
    error = std::max(error, high - low);
    color = std::clamp(color, 0.0, 1.0);
  }
  pixel.Error = error;
}

vtkSmartPointer<vtkImageData> MakePicture(const std::array<int, 2>& size, int components)
{
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(size[0], size[1], 1);
  picture->AllocateScalars(VTK_FLOAT, components);
  return picture;
}

ReferenceStatistics MakeStatistics(const std::vector<ReferencePixel>& pixels)
{
  ReferenceStatistics statistics;
  double sumOfSquares = 0.0;
  for (const ReferencePixel& pixel : pixels)
  {
    statistics.LargestError = std::max(statistics.LargestError, pixel.Error);
    sumOfSquares += pixel.Error * pixel.Error;
    statistics.PixelsNotConverged += pixel.Converged ? 0 : 1;
    statistics.Samples += pixel.Samples;
    statistics.ShadowRays += pixel.ShadowRays;
  }
  statistics.RootMeanSquareError = std::sqrt(sumOfSquares / static_cast<double>(pixels.size()));
  return statistics;
}

ReferencePicture MakePicture(
  const std::array<int, 2>& size, const std::vector<ReferencePixel>& pixels)
{
  ReferencePicture picture{ MakePicture(size, 4), MakePicture(size, 1), MakeStatistics(pixels) };
  auto* color = static_cast<float*>(picture.Colors->GetScalarPointer());
  auto* error = static_cast<float*>(picture.Errors->GetScalarPointer());
  for (const ReferencePixel& pixel : pixels)
  {
    color = std::transform(pixel.Color.begin(), pixel.Color.end(), color,
      [](double value) { return static_cast<float>(value); });
    *error++ = static_cast<float>(pixel.Error);
  }
  return picture;
}
}

//------------------------------------------------------------------------------
class ReferenceIntegrator::Internals
{
public:
  Internals(const ReferenceScene& scene, const ReferenceOptions& options)
    : Size(scene.Size)
    , Background(scene.Background)
    , Options(options)
    , Model(Check(scene, options), options.Tolerance / GreyLevels, options.MostSamplesPerPixel)
    , Rays(scene)
  {
    this->Warn();
  }

  void Warn();
  ReferencePixel Compose(const RayRadiance& ray) const;

  std::array<int, 2> Size;
  Rgb Background;
  ReferenceOptions Options;
  RenderingModel Model;
  PictureRays Rays;
  std::vector<std::string> Warnings;
};

//------------------------------------------------------------------------------
void ReferenceIntegrator::Internals::Warn()
{
  const std::size_t replaced = this->Model.Matter.GetField().GetNumberOfReplaced();
  if (replaced > 0)
  {
    this->Warnings.push_back(std::to_string(replaced) +
      " voxels that are NaN or infinite count as the smallest or the largest finite value");
  }
  const std::string fault =
    this->Model.Lighting ? this->Model.Lighting->GetEnvironmentFault() : std::string();
  if (!fault.empty())
  {
    this->Warnings.push_back("the environment map reflects nothing: " + fault);
  }
}

//------------------------------------------------------------------------------
ReferencePixel ReferenceIntegrator::Internals::Compose(const RayRadiance& ray) const
{
  ReferencePixel pixel;
  pixel.Error = ray.Error;
  for (int channel = 0; channel < 3; ++channel)
  {
    pixel.Color[channel] = ray.Radiance[channel] + ray.Transmittance * this->Background[channel];
  }
  pixel.Color[3] = 1.0 - ray.Transmittance;
  pixel.Converged = ray.Converged;
  if (!this->Model.Absorbs())
  {
    ClampEmission(pixel);
    pixel.Converged = pixel.Error <= this->Model.Tolerance;
  }
  pixel.Error *= GreyLevels;
  pixel.Samples = ray.Samples;
  pixel.ShadowRays = ray.ShadowRays;
  return pixel;
}

//------------------------------------------------------------------------------
ReferenceIntegrator::ReferenceIntegrator(
  const ReferenceScene& scene, const ReferenceOptions& options)
  : Internal(std::make_unique<Internals>(scene, options))
{
}

//------------------------------------------------------------------------------
ReferenceIntegrator::~ReferenceIntegrator() = default;

//------------------------------------------------------------------------------
const std::vector<std::string>& ReferenceIntegrator::GetWarnings() const
{
  return this->Internal->Warnings;
}

//------------------------------------------------------------------------------
ReferencePixel ReferenceIntegrator::ComputePixel(double x, double y) const
{
  const VolumeMatter& matter = this->Internal->Model.Matter;
  const VolumeFrame& frame = matter.GetFrame();
  const ViewRay view = this->Internal->Rays.GetRay(x, y);
  RayRadiance radiance;
  if (frame.IsInvertible())
  {
    VolumeRay ray =
      MakeRay(frame, frame.ToIndex(view.Start), frame.DirectionToIndex(view.Direction));
    if (matter.GetRegion().Clip(ray))
    {
      radiance = RadianceIntegral(this->Internal->Model, ray, view.Direction * -1.0).Compute();
    }
  }
  return this->Internal->Compose(radiance);
}

//------------------------------------------------------------------------------
std::optional<ReferencePicture> ReferenceIntegrator::Render() const
{
  const std::array<int, 2>& size = this->Internal->Size;
  const vtkIdType count = static_cast<vtkIdType>(size[0]) * size[1];
  std::vector<ReferencePixel> pixels(count);
  const auto compute = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      pixels[i] = this->ComputePixel(i % size[0] + 0.5, i / size[0] + 0.5);
    }
  };
  const vtkIdType part = std::max(count / ProgressParts, 16 * PixelsAtOnce);
  const auto& progress = this->Internal->Options.Progress;
  for (vtkIdType begin = 0; begin < count; begin += part)
  {
    if (progress && !progress(static_cast<double>(begin) / count))
    {
      return std::nullopt;
    }
    vtkSMPTools::For(begin, std::min(begin + part, count), PixelsAtOnce, compute);
  }
  if (progress && !progress(1.0))
  {
    return std::nullopt;
  }
  return MakePicture(size, pixels);
}

}
