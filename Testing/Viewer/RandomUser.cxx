#include "RandomUser.h"

#include "AppearancePanel.h"
#include "PresetPanel.h"
#include "TransferFunctionChart.h"
#include "TransferFunctionPanel.h"

#include <QAction>

#include <vtkPiecewiseFunction.h>

namespace penumbra
{

//------------------------------------------------------------------------------
RandomUser::RandomUser(ViewerSession& session, unsigned int seed)
  : Session(session)
  , Generator(seed)
{
}

//------------------------------------------------------------------------------
void RandomUser::EditOnce()
{
  switch (this->Whole(12))
  {
    case 0:
    case 1:
      return this->Trigger("addLight" + QString::number(this->Whole(4)));
    case 2:
      return this->Trigger("removeLight");
    case 3:
      return this->Trigger("undo");
    case 4:
      return this->Trigger("redo");
    case 5:
      return this->Trigger("rig" + QString::number(this->Whole(4)));
    case 6:
      return this->ChangeLight();
    case 7:
      return this->MoveOpacityPoint();
    case 8:
      return this->Session.Window.GetAppearance()->GetPresets()->Apply(
        this->Whole(2) ? "cloud" : "surface", {});
    case 9:
      return this->ChangeMaterial();
    case 10:
      return this->Clip();
    default:
      return this->MoveCamera();
  }
}

//------------------------------------------------------------------------------
void RandomUser::Trigger(const QString& name)
{
  auto* const action = this->Session.Window.findChild<QAction*>(name);
  if (action->isEnabled()) // else no user could
  {
    action->trigger();
  }
}

//------------------------------------------------------------------------------
void RandomUser::Edit(const std::function<void(SceneDescription&)>& change)
{
  this->Session.Document.Edit("edit", change);
}

//------------------------------------------------------------------------------
void RandomUser::ChangeLight()
{
  const auto count = this->Session.Document.GetScene().Lights.size();
  if (count > 0)
  {
    LightDescription& changed = this->Light;
    changed = this->Session.Document.GetScene().Lights[this->Whole(static_cast<int>(count))];
    const auto place = static_cast<std::size_t>(this->Whole(static_cast<int>(count)));
    changed.Diffuse = this->Color();
    changed.Intensity = 2.0 * this->Part();
    changed.Shadow = static_cast<ShadowKind>(this->Whole(3));
    changed.On = this->Whole(4) > 0;
    changed.ConeAngle = 180.0 * this->Part();
    this->Edit([&](SceneDescription& scene) { scene.Lights[place] = changed; });
  }
}

//------------------------------------------------------------------------------
void RandomUser::MoveOpacityPoint()
{
  vtkPiecewiseFunction* opacity =
    this->Session.Window.GetAppearance()->GetTransferFunction()->GetChart()->GetOpacity();
  double node[4];
  const int point = this->Whole(opacity->GetSize());
  opacity->GetNodeValue(point, node);
  node[1] = this->Part();
  opacity->SetNodeValue(point, node);
}

//------------------------------------------------------------------------------
void RandomUser::ChangeMaterial()
{
  this->Edit(
    [this](SceneDescription& scene)
    {
      scene.Material.Model = static_cast<ReflectionModel>(this->Whole(6));
      scene.Material.Diffuse = this->Part();
      scene.Material.Specular = this->Part();
      scene.Gradient = static_cast<GradientEstimator>(this->Whole(4));
      scene.Image.Background = this->Color();
    });
}

//------------------------------------------------------------------------------
void RandomUser::Clip()
{
  this->Edit(
    [this](SceneDescription& scene)
    {
      scene.Volume.Cropping = { 0.0, 20.0 + 11.0 * this->Part(), 0.0, 31.0, 3.0, 31.0 };
      scene.ClippingPlanes = { { { 15.5, 15.5, 15.5 }, { this->Part(), -1.0, this->Part() } } };
    });
}

//------------------------------------------------------------------------------
void RandomUser::MoveCamera()
{
  CameraDescription camera = this->Session.Window.GetView()->GetCamera();
  camera.Position = Sum(*camera.Position, { this->Part(), this->Part(), -this->Part() });
  this->Session.Window.GetView()->SetCamera(camera);
}

}
