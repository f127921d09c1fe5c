#include "ClippingForm.h"

#include "ClippingFrame.h"
#include "ClippingPlaneList.h"
#include "PanelButton.h"
#include "PropertyForm.h"
#include "SceneDocument.h"
#include "VolumeBox.h"
#include "VolumeView.h"

#include <QAction>
#include <QObject>
#include <QToolButton>

#include <vtkImageData.h>

#include <algorithm>

namespace penumbra
{
namespace
{
bool HasBox(const SceneDescription& scene)
{
  return scene.Volume.Cropping.has_value();
}

bool HasPlane(const SceneDescription& scene)
{
  return !scene.ClippingPlanes.empty();
}

// A side of the box, 0 to 5 for x, x, y, y, z, z, in percent of the volume along its axis.
PropertyAccess<double> AccessToSide(SceneDocument* document, int side)
{
  const int first = side / 2 * 2;
  const auto image = [document] { return document->GetVoxels().Volume; };
  return { [=](const SceneDescription& scene)
    {
      const CroppingBox all = WholeBox(image());
      const double place = KeptBox(scene, image())[side];
      return 100.0 * (place - all[first]) / (all[first + 1] - all[first]);
    },
    [=](SceneDescription& scene, const double& percent)
    {
      const CroppingBox all = WholeBox(image());
      const double place = all[first] + percent / 100.0 * (all[first + 1] - all[first]);
      scene.Volume.Cropping = WithSideAt(KeptBox(scene, image()), side, place, all);
    } };
}

template <typename Member>
PropertyAccess<Vector3> AccessToPlane(SceneDocument* document, Member member)
{
  return { [=](const SceneDescription& scene)
    { return scene.ClippingPlanes[document->GetSelectedPlane()].*member; },
    [=](SceneDescription& scene, const Vector3& value)
    { scene.ClippingPlanes[document->GetSelectedPlane()].*member = value; } };
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

// Of the selected plane, in percent of the volume along its normal.
PropertyAccess<double> AccessToDepth(SceneDocument* document)
{
  return { [=](const SceneDescription& scene)
    {
      const auto& plane = scene.ClippingPlanes[document->GetSelectedPlane()];
      const Vector3 normal = UnitVector(plane.Normal);
      const DepthRange range = DepthsAlong(normal, scene, document->GetVoxels().Volume);
      return std::clamp(
        100.0 * (Dot(plane.Origin, normal) - range.Nearest) / (range.Farthest - range.Nearest), 0.0,
        100.0);
    },
    [=](SceneDescription& scene, const double& percent)
    {
      auto& plane = scene.ClippingPlanes[document->GetSelectedPlane()];
      const Vector3 normal = UnitVector(plane.Normal);
      const DepthRange range = DepthsAlong(normal, scene, document->GetVoxels().Volume);
      const double depth = range.Nearest + percent / 100.0 * (range.Farthest - range.Nearest);
      plane.Origin = Sum(plane.Origin, Scaled(normal, depth - Dot(plane.Origin, normal)));
    } };
}

void AddBox(PropertyForm* form, SceneDocument* document, QAction* drag)
{
  const auto whole = [document] { return WholeBox(document->GetVoxels().Volume); };
  form->AddSwitch(
    { QObject::tr("Clipping box"),
      QObject::tr("Show only what is within a box. What is cut away casts no shadow.") },
    { HasBox,
      [=](SceneDescription& scene, const bool& on)
      {
        scene.Volume.Cropping.reset();
        if (on)
        {
          scene.Volume.Cropping = whole();
          drag->setChecked(true);
        }
      } });
  const QString sides[] = { QObject::tr("x from"), QObject::tr("x to"), QObject::tr("y from"),
    QObject::tr("y to"), QObject::tr("z from"), QObject::tr("z to") };
  for (int side = 0; side < 6; ++side)
  {
    form->AddSlider({ sides[side],
                      QObject::tr("A side of the clipping box, in percent of the volume along its "
                                  "axis") },
      { 0.0, 100.0, 1, QObject::tr(" %") }, 100.0, AccessToSide(document, side));
    form->ShowLastWhen(HasBox);
  }
  QToolButton* reset = MakePanelButton(
    QObject::tr("Reset the box"), QObject::tr("Let the box hold the whole volume again"), form);
  reset->setObjectName("resetBox");
  QObject::connect(reset, &QToolButton::clicked, form,
    [=]
    {
      document->Edit(QObject::tr("reset of the clipping box"),
        [=](SceneDescription& scene) { scene.Volume.Cropping = whole(); });
    });
  form->AddWidget(reset);
  form->ShowLastWhen(HasBox);
}

void AddPlanes(PropertyForm* form, SceneDocument* document, VolumeView* view, QAction* drag)
{
  auto* const list = new ClippingPlaneList(document, view, form);
  QObject::connect(list, &ClippingPlaneList::added, form, [drag] { drag->setChecked(true); });
  form->AddWidget(list);
  form->AddSlider({ QObject::tr("Depth of cut"),
                    QObject::tr("How far into the volume the selected plane cuts, in percent") },
    { 0.0, 100.0, 1, QObject::tr(" %") }, 100.0, AccessToDepth(document));
  form->ShowLastWhen(HasPlane);
  form->AddVector({ QObject::tr("Plane through"),
                    QObject::tr("A point that the selected plane goes through, in the world") },
    { -1e6, 1e6, 2 }, AccessToPlane(document, &ClippingPlaneDescription::Origin));
  form->ShowLastWhen(HasPlane);
  form->AddVector({ QObject::tr("Keeps towards"),
                    QObject::tr("The plane's normal: it points to the side that stays") },
    { -1e6, 1e6, 3 }, AccessToPlane(document, &ClippingPlaneDescription::Normal));
  form->ShowLastWhen(HasPlane);
}
}

//------------------------------------------------------------------------------
void FillClippingForm(PropertyForm* form, SceneDocument* document, VolumeView* view, QAction* drag)
{
  form->AddHeading(QObject::tr("Clipping"));
  AddBox(form, document, drag);
  AddPlanes(form, document, view, drag);
  auto* const show = new QToolButton(form);
  show->setDefaultAction(drag);
  show->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  show->setFocusPolicy(Qt::StrongFocus);
  form->AddWidget(show);
  form->ShowLastWhen(
    [](const SceneDescription& scene) { return HasBox(scene) || HasPlane(scene); });
}

}
