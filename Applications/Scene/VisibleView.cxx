#include "VisibleView.h"

#include "Preset.h"
#include "SceneCamera.h"
#include "VolumeBox.h"
#include "VolumeFields.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
// Voxels that are looked at along the longest axis, at most.
constexpr int LargestSample = 128;

// Opacity per unit distance that counts as visible.
constexpr double LeastOpacity = 0.05;

// Of the visible voxels, those left out on each side: single ones far away are noise.
constexpr double LeftOut = 0.0004;

// Of the picture, what is left free around them.
constexpr double Margin = 1.06;

constexpr int Rounds = 8;

// Fewer visible points tell nothing.
constexpr std::size_t EnoughPoints = 50;

// Off the middle by this part of its length, a thing has a heavy end.
constexpr double HeavyEnd = 0.2;

// The way to the eye: right of the middle of the picture is where the patient's left is.
constexpr double Sideways = -0.45;
constexpr double Upwards = 0.3;

struct Axes
{
  Vector3 Side;
  Vector3 Front;
  Vector3 Up;
  std::string Reason;
};

std::vector<Vector3> VisiblePoints(const SceneDescription& scene, vtkImageData* image)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  for (const auto& point : *scene.TransferFunction.Opacity)
  {
    opacity->AddPoint(point[0], point[1]);
  }
  const int* dimensions = image->GetDimensions();
  const double* spacing = image->GetSpacing();
  const double* origin = image->GetOrigin();
  const int stride = std::max({ dimensions[0], dimensions[1], dimensions[2] }) / LargestSample + 1;
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  double toWorld[16];
  vtkMatrix4x4::Multiply4x4(
    scene.Volume.Transform.data(), image->GetIndexToPhysicalMatrix()->GetData(), toWorld);
  const auto isCropped = [&](int axis, int index)
  {
    const double place = origin[axis] + index * spacing[axis];
    const auto& cropping = scene.Volume.Cropping;
    return cropping && (place < (*cropping)[2 * axis] || place > (*cropping)[2 * axis + 1]);
  };
  std::vector<Vector3> points;
  for (int k = 0; k < dimensions[2]; k += stride)
  {
    for (int j = 0; j < dimensions[1]; j += stride)
    {
      for (int i = 0; i < dimensions[0]; i += stride)
      {
        const vtkIdType voxel = i + dimensions[0] * (j + static_cast<vtkIdType>(dimensions[1]) * k);
        if (isCropped(0, i) || isCropped(1, j) || isCropped(2, k) ||
          !(opacity->GetValue(scalars->GetComponent(voxel, 0)) > LeastOpacity))
        {
          continue;
        }
        const double index[4] = { static_cast<double>(i), static_cast<double>(j),
          static_cast<double>(k), 1.0 };
        double world[4];
        vtkMatrix4x4::MultiplyPoint(toWorld, index, world);
        points.push_back({ world[0], world[1], world[2] });
      }
    }
  }
  return points;
}

bool IsNamed(const std::filesystem::path& file, const std::string& end)
{
  std::string name = file.filename().u8string();
  std::transform(name.begin(), name.end(), name.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
}

// The range of values without the outermost ones.
std::array<double, 2> RangeOf(std::vector<double> values)
{
  const auto last = static_cast<double>(values.size() - 1);
  const auto at = [&values, last](double part)
  {
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(part * last);
    std::nth_element(values.begin(), place, values.end());
    return *place;
  };
  return { at(LeftOut), at(1.0 - LeftOut) };
}

const char* const AxisNames[] = { "x", "y", "z" };

Axes AxesWithUp(vtkImageData* image, int axis, double sign, const std::string& reason)
{
  const auto column = [image](int of)
  {
    const double* d = image->GetDirectionMatrix()->GetData();
    return Vector3{ d[of], d[3 + of], d[6 + of] };
  };
  return { column((axis + 1) % 3), Scaled(column((axis + 2) % 3), -sign),
    Scaled(column(axis), sign), reason };
}

// The longest axis, where one is clearly longer than z.
int LongestAxis(vtkImageData* image)
{
  constexpr double clearly = 1.1;
  const auto length = [image](int axis)
  { return image->GetSpacing()[axis] * image->GetDimensions()[axis]; };
  int longest = 2;
  for (int axis = 0; axis < 2; ++axis)
  {
    longest = length(axis) > clearly * length(longest) ? axis : longest;
  }
  return longest;
}

// How far the middle of the points is from the middle of their box, in parts of its length.
std::array<double, 3> Imbalance(const std::vector<Vector3>& points)
{
  std::array<double, 3> imbalance{};
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<double> places;
    double sum = 0.0;
    for (const Vector3& point : points)
    {
      places.push_back(point[axis]);
      sum += point[axis];
    }
    const double mean = sum / static_cast<double>(places.size());
    const auto range = RangeOf(std::move(places));
    const double length = range[1] - range[0];
    imbalance[axis] = length > 0.0 ? (mean - 0.5 * (range[0] + range[1])) / length : 0.0;
  }
  return imbalance;
}

bool HasOrientation(const SceneDescription& scene, vtkImageData* image)
{
  return !TextField(image, "Modality").empty() || IsNamed(scene.Volume.File, ".nii") ||
    IsNamed(scene.Volume.File, ".nii.gz") || !image->GetDirectionMatrix()->IsIdentity() ||
    (scene.TransferFunction.FromPreset && !scene.TransferFunction.FromPreset->Modalities.empty());
}

// Of volumes that say nothing of their orientation: things stand on their heavy end.
Axes AxesOfUnknown(
  const SceneDescription& scene, vtkImageData* image, const std::vector<Vector3>& points)
{
  if (points.size() >= EnoughPoints)
  {
    const auto imbalance = Imbalance(points);
    for (int axis = 0; axis < 3; ++axis)
    {
      if (std::abs(imbalance[axis]) > HeavyEnd)
      {
        const bool isUp = imbalance[axis] < 0.0;
        return AxesWithUp(image, axis, isUp ? 1.0 : -1.0,
          std::string("the volume has no orientation, and it is heavier at the ") +
            (isUp ? "lower" : "upper") + " end of " + AxisNames[axis] + ", taken for its base");
      }
    }
  }
  const int longest = IsNamed(scene.Volume.File, ".raw") ? LongestAxis(image) : 2;
  return AxesWithUp(image, longest, 1.0,
    std::string("the volume has no orientation, and ") + AxisNames[longest] +
      (longest == 2 ? " is taken for up" : " is its longest axis"));
}

Axes AxesOf(const SceneDescription& scene, vtkImageData* image, const std::vector<Vector3>& points)
{
  if (!HasOrientation(scene, image))
  {
    return AxesOfUnknown(scene, image, points);
  }
  if (IsNamed(scene.Volume.File, ".nii") || IsNamed(scene.Volume.File, ".nii.gz"))
  {
    return { { -1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 },
      "y points to the patient's front and z to the head, as NIfTI has it" };
  }
  return { { 1.0, 0.0, 0.0 }, { 0.0, -1.0, 0.0 }, { 0.0, 0.0, 1.0 },
    "-y points to the patient's front and z to the head, as DICOM has it" };
}

// Moves the focal point and the eye until the points fill the picture.
void FitTo(const std::vector<Vector3>& points, const Vector3& toEye, double aspect,
  CameraDescription& camera)
{
  const Vector3 right = UnitVector(Cross(*camera.ViewUp, toEye));
  const Vector3 up = Cross(toEye, right);
  const double slope = std::tan(vtkMath::RadiansFromDegrees(camera.ViewAngle) / 2.0);
  Vector3 focal = *camera.FocalPoint;
  double distance = Length(Difference(*camera.Position, focal));
  for (int round = 0; round < Rounds; ++round)
  {
    std::vector<double> across;
    std::vector<double> along;
    for (const Vector3& point : points)
    {
      const Vector3 offset = Difference(point, focal);
      const double depth = std::max(distance - Dot(offset, toEye), 1e-3 * distance);
      across.push_back(Dot(offset, right) / depth);
      along.push_back(Dot(offset, up) / depth);
    }
    const auto x = RangeOf(std::move(across));
    const auto y = RangeOf(std::move(along));
    focal = Sum(focal, Scaled(right, 0.5 * (x[0] + x[1]) * distance));
    focal = Sum(focal, Scaled(up, 0.5 * (y[0] + y[1]) * distance));
    const double part = std::max((x[1] - x[0]) / aspect, y[1] - y[0]) / 2.0 / slope;
    distance *= std::max(part, 0.05) * Margin;
  }
  camera.FocalPoint = focal;
  camera.Position = Sum(focal, Scaled(toEye, distance));
}
}

//------------------------------------------------------------------------------
std::string ViewFromTheFront(SceneDescription& scene, vtkImageData* image)
{
  const auto points = VisiblePoints(scene, image);
  const Axes axes = AxesOf(scene, image, points);
  const auto& size = scene.Image.Size;
  const double aspect = static_cast<double>(size[0]) / size[1];
  const VolumeBox box(image, scene.Volume.Transform);
  CameraDescription& camera = scene.Camera;
  camera.ViewUp = axes.Up;
  if (points.size() >= EnoughPoints)
  {
    const Vector3 toEye =
      UnitVector(Sum(Sum(axes.Front, Scaled(axes.Side, Sideways)), Scaled(axes.Up, Upwards)));
    const double diagonal = Length(Difference(box.GetCorners().back(), box.GetCorners().front()));
    camera.FocalPoint = box.GetCenter();
    camera.Position = Sum(*camera.FocalPoint, Scaled(toEye, 3.0 * diagonal));
    FitTo(points, toEye, aspect, camera);
  }
  ResolveCamera(camera, box, aspect);
  return "seen from the front, a little from the side and from above: " + axes.Reason;
}

}
