#include "ClippingForm.h"

#include "PropertyForm.h"
#include "SceneDocument.h"
#include "VolumeBox.h"
#include "VolumeView.h"

#include <QObject>
#include <QPushButton>

#include <vtkImageData.h>

#include <algorithm>

namespace penumbra
{
namespace
{
// Least part of an axis that a clipping box keeps, in percent.
constexpr double LeastPercent = 0.5;

using Bounds = std::array<double, 6>;

Bounds WholeBox(vtkImageData* image)
{
  const int* size = image->GetDimensions();
  const double* origin = image->GetOrigin();
  const double* spacing = image->GetSpacing();
  Bounds bounds;
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds[2 * axis] = origin[axis];
    bounds[2 * axis + 1] = origin[axis] + std::max(size[axis] - 1, 1) * spacing[axis];
  }
  return bounds;
}

// A side of the box, 0 to 5 for x, x, y, y, z, z, in percent of the volume along its axis.
PropertyAccess<double> AccessToSide(SceneDocument* document, int side)
{
  const auto whole = [document] { return WholeBox(document->GetVoxels().Volume); };
  const int axis = side / 2;
  return { [=](const SceneDescription& scene)
    {
      const Bounds all = whole();
      const double place = scene.Volume.Cropping.value_or(all)[side];
      return 100.0 * (place - all[2 * axis]) / (all[2 * axis + 1] - all[2 * axis]);
    },
    [=](SceneDescription& scene, const double& percent)
    {
      const Bounds all = whole();
      const double length = all[2 * axis + 1] - all[2 * axis];
      Bounds box = scene.Volume.Cropping.value_or(all);
      const double least = LeastPercent / 100.0 * length;
      const double place = all[2 * axis] + percent / 100.0 * length;
      box[side] = side % 2 == 0 ? std::min(place, box[side + 1] - least)
                                : std::max(place, box[side - 1] + least);
      scene.Volume.Cropping = box;
    } };
}

struct DepthRange
{
  double Nearest;
  double Farthest;
};

DepthRange DepthsAlong(const Vector3& normal, const SceneDescription& scene, vtkImageData* image)
{
  const VolumeBox box(image, scene.Volume.Transform);
  DepthRange range = { 1e300, -1e300 };
  for (const Vector3& corner : box.GetCorners())
  {
    range.Nearest = std::min(range.Nearest, Dot(corner, normal));
    range.Farthest = std::max(range.Farthest, Dot(corner, normal));
  }
  return range;
}

// Of the last plane, in percent of the volume along its normal.
PropertyAccess<double> AccessToDepth(SceneDocument* document)
{
  return { [=](const SceneDescription& scene)
    {
      const ClippingPlaneDescription& plane = scene.ClippingPlanes.back();
      const Vector3 normal = UnitVector(plane.Normal);
      const DepthRange range = DepthsAlong(normal, scene, document->GetVoxels().Volume);
      return std::clamp(
        100.0 * (Dot(plane.Origin, normal) - range.Nearest) / (range.Farthest - range.Nearest), 0.0,
        100.0);
    },
    [=](SceneDescription& scene, const double& percent)
    {
      ClippingPlaneDescription& plane = scene.ClippingPlanes.back();
      const Vector3 normal = UnitVector(plane.Normal);
      const DepthRange range = DepthsAlong(normal, scene, document->GetVoxels().Volume);
      const double depth = range.Nearest + percent / 100.0 * (range.Farthest - range.Nearest);
      plane.Origin = Sum(plane.Origin, Scaled(normal, depth - Dot(plane.Origin, normal)));
    } };
}

// Cuts away what is before the point that the camera looks at.
ClippingPlaneDescription PlaneAcrossView(const VolumeView* view)
{
  const ViewFrame frame = view->GetFrame();
  return { frame.FocalPoint, Scaled(frame.Backward, -1.0) };
}

void AddBox(PropertyForm* form, SceneDocument* document)
{
  const auto hasBox = [](const SceneDescription& scene)
  { return scene.Volume.Cropping.has_value(); };
  form->AddSwitch(
    { QObject::tr("Clipping box"),
      QObject::tr("Show only what is within a box. What is cut away casts no shadow.") },
    { hasBox,
      [=](SceneDescription& scene, const bool& on)
      {
        scene.Volume.Cropping.reset();
        if (on)
        {
          scene.Volume.Cropping = WholeBox(document->GetVoxels().Volume);
        }
      } });
  const QString sides[] = { QObject::tr("x from"), QObject::tr("x to"), QObject::tr("y from"),
    QObject::tr("y to"), QObject::tr("z from"), QObject::tr("z to") };
  for (int side = 0; side < 6; ++side)
  {
    form->AddSlider({ sides[side],
                      QObject::tr("A side of the clipping box, in percent of the volume along its "
                                  "axis") },
      { 0.0, 100.0, 1 }, 100.0, AccessToSide(document, side));
    form->ShowLastWhen(hasBox);
  }
}

void AddPlane(PropertyForm* form, SceneDocument* document, VolumeView* view)
{
  const auto hasPlane = [](const SceneDescription& scene) { return !scene.ClippingPlanes.empty(); };
  form->AddSwitch(
    { QObject::tr("Cutting plane"),
      QObject::tr("Cut away what lies between you and the middle of the view. What is "
                  "cut away casts no shadow.") },
    { hasPlane,
      [=](SceneDescription& scene, const bool& on)
      {
        scene.ClippingPlanes.clear();
        if (on)
        {
          scene.ClippingPlanes.push_back(PlaneAcrossView(view));
        }
      } });
  form->AddSlider({ QObject::tr("Depth of cut"),
                    QObject::tr("How far into the volume the plane cuts, in percent") },
    { 0.0, 100.0, 1 }, 100.0, AccessToDepth(document));
  form->ShowLastWhen(hasPlane);
  auto* const face = new QPushButton(QObject::tr("Turn the plane to face me"), form);
  face->setToolTip(QObject::tr("Cut along your view as it is now"));
  QObject::connect(face, &QPushButton::clicked, form,
    [=]
    {
      document->Edit(QObject::tr("turn of the cutting plane"),
        [=](SceneDescription& scene) { scene.ClippingPlanes.back() = PlaneAcrossView(view); });
    });
  form->AddWidget(face);
  form->ShowLastWhen(hasPlane);
}
}

//------------------------------------------------------------------------------
void FillClippingForm(PropertyForm* form, SceneDocument* document, VolumeView* view)
{
  AddBox(form, document);
  AddPlane(form, document, view);
}

}
