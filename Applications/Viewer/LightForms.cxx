#include "LightForms.h"

#include "LightEdits.h"
#include "PropertyForm.h"
#include "SceneDocument.h"
#include "VolumeView.h"

namespace penumbra
{
namespace
{
constexpr double Far = 1e6;

template <typename Value, typename Member>
PropertyAccess<Value> AccessTo(SceneDocument* document, Member LightDescription::*member)
{
  return { [=](const SceneDescription& scene)
    { return static_cast<Value>(scene.Lights[document->GetSelectedLight()].*member); },
    [=](SceneDescription& scene, const Value& value)
    { scene.Lights[document->GetSelectedLight()].*member = static_cast<Member>(value); } };
}

PropertyForm::Condition WhenType(
  SceneDocument* document, const std::function<bool(LightType)>& condition)
{
  return [=](const SceneDescription& scene)
  { return condition(scene.Lights[document->GetSelectedLight()].Type); };
}

PropertyForm::Condition WhenShadow(
  SceneDocument* document, const std::function<bool(ShadowKind)>& condition)
{
  return [=](const SceneDescription& scene)
  { return condition(scene.Lights[document->GetSelectedLight()].Shadow); };
}

void AddShadow(PropertyForm* form, SceneDocument* document)
{
  form->AddChoice({ QObject::tr("Shadow"),
                    QObject::tr("Soft: what is semi-transparent dims the light, as tissue does. "
                                "Hard: sharp edges, light or no light. None: everything is lit.") },
    { QObject::tr("None"), QObject::tr("Soft"), QObject::tr("Hard") },
    AccessTo<int>(document, &LightDescription::Shadow));
}

void AddBrightness(PropertyForm* form, SceneDocument* document)
{
  form->AddSlider({ QObject::tr("Brightness"),
                    QObject::tr("How strong the light is; 1 is ordinary, more may burn out.") },
    { 0.0, 1000.0, 3 }, 2.0, AccessTo<double>(document, &LightDescription::Intensity));
}

void AddFrame(PropertyForm* form, SceneDocument* document, VolumeView* view)
{
  PropertyAccess<int> access{ [=](const SceneDescription& scene)
    { return static_cast<int>(scene.Lights[document->GetSelectedLight()].Frame); },
    [=](SceneDescription& scene, int frame)
    {
      ChangeFrame(scene.Lights[document->GetSelectedLight()], static_cast<LightFrame>(frame),
        view->GetFrame());
    } };
  form->AddChoice(
    { QObject::tr("When you turn"),
      QObject::tr("Whether the light stays where it is in the scene when you turn it, "
                  "or moves along with you, like a lamp on your head.") },
    { QObject::tr("It stays fixed in the scene"), QObject::tr("It follows the camera") }, access);
  form->ShowLastWhen(
    WhenType(document, [](LightType type) { return type != LightType::Headlight; }));
}

void AddPlace(PropertyForm* form, SceneDocument* document)
{
  form->AddVector({ QObject::tr("Position"),
                    QObject::tr("Where the light is, in the scene's lengths (millimetres in a CT); "
                                "of a light that follows the camera: right, up and towards you "
                                "from the eye.") },
    { -Far, Far, 3 }, AccessTo<Vector3>(document, &LightDescription::Position));
  form->ShowLastWhen(WhenType(
    document, [](LightType type) { return type == LightType::Point || type == LightType::Spot; }));
  form->AddVector({ QObject::tr("Shines towards"),
                    QObject::tr("The way the light travels; any length but zero.") },
    { -Far, Far, 3 }, AccessTo<Vector3>(document, &LightDescription::Direction));
  form->ShowLastWhen(WhenType(document,
    [](LightType type) { return type == LightType::Directional || type == LightType::Spot; }));
}

void AddCone(PropertyForm* form, SceneDocument* document)
{
  const auto isSpot = WhenType(document, [](LightType type) { return type == LightType::Spot; });
  form->AddSlider(
    { QObject::tr("Cone angle"),
      QObject::tr("Half the angle of the spot's cone in degrees; from 90 on it shines "
                  "all around.") },
    { 0.0, 180.0, 1, QObject::tr("\u00b0") }, 90.0,
    AccessTo<double>(document, &LightDescription::ConeAngle));
  form->ShowLastWhen(isSpot);
  form->AddSlider({ QObject::tr("Cone fall-off"),
                    QObject::tr("0: evenly bright up to the cone's edge; more: brighter in its "
                                "middle.") },
    { 0.0, 128.0, 2 }, 20.0, AccessTo<double>(document, &LightDescription::Exponent));
  form->ShowLastWhen(isSpot);
  form->AddVector({ QObject::tr("Attenuation"),
                    QObject::tr("Constant, linear and quadratic: the light reaches a distance d as "
                                "1 / (constant + linear d + quadratic d d).") },
    { 0.0, Far, 6 }, AccessTo<Vector3>(document, &LightDescription::Attenuation));
  form->ShowLastWhen(WhenType(
    document, [](LightType type) { return type == LightType::Point || type == LightType::Spot; }));
}

void AddShadowDetails(PropertyForm* form, SceneDocument* document)
{
  form->AddSlider({ QObject::tr("Shadow threshold"),
                    QObject::tr("How much matter must lie before the light until its hard shadow "
                                "falls: 0 anything, 1 only what is opaque.") },
    { 0.0, 1.0, 3 }, 1.0, AccessTo<double>(document, &LightDescription::OpacityThreshold));
  form->ShowLastWhen(
    WhenShadow(document, [](ShadowKind kind) { return kind == ShadowKind::Hard; }));
  PropertyAccess<double> bias{ [=](const SceneDescription& scene)
    { return *scene.Lights[document->GetSelectedLight()].ShadowBias; },
    [=](SceneDescription& scene, double value)
    { scene.Lights[document->GetSelectedLight()].ShadowBias = value; } };
  form->AddNumber({ QObject::tr("Shadow bias"),
                    QObject::tr("How far from a point its shadow begins, in the volume's lengths: "
                                "less gives closer contact, too little darkens all surfaces.") },
    { 0.0, Far, 3 }, bias);
  form->ShowLastWhen(
    WhenShadow(document, [](ShadowKind kind) { return kind != ShadowKind::None; }));
}
}

//------------------------------------------------------------------------------
bool HasSelectedLight(const SceneDocument* document)
{
  return document->IsOpen() && document->GetSelectedLight() >= 0;
}

//------------------------------------------------------------------------------
void FillSimpleLightForm(PropertyForm* form, SceneDocument* document)
{
  form->EnableWhen([document](const SceneDescription&) { return HasSelectedLight(document); });
  form->AddColor(
    { QObject::tr("Colour"), QObject::tr("The colour that the light gives to surfaces.") },
    AccessTo<Vector3>(document, &LightDescription::Diffuse));
  AddBrightness(form, document);
  AddShadow(form, document);
}

//------------------------------------------------------------------------------
void FillAdvancedLightForm(PropertyForm* form, SceneDocument* document, VolumeView* view)
{
  form->EnableWhen([document](const SceneDescription&) { return HasSelectedLight(document); });
  form->AddText({ QObject::tr("Name"), QObject::tr("What this light is called in the lists.") },
    { [=](const SceneDescription& scene)
      { return QString::fromStdString(scene.Lights[document->GetSelectedLight()].Name); },
      [=](SceneDescription& scene, const QString& name)
      { scene.Lights[document->GetSelectedLight()].Name = name.toStdString(); } });
  form->AddSwitch({ QObject::tr("On"), QObject::tr("Whether the light shines.") },
    AccessTo<bool>(document, &LightDescription::On));
  form->AddChoice(
    { QObject::tr("Type"),
      QObject::tr("Directional: from far away, like the sun. Point: a lamp that shines "
                  "all around. Spot: a lamp with a cone. Headlight: at your eye.") },
    { QObject::tr("Directional"), QObject::tr("Point"), QObject::tr("Spot"),
      QObject::tr("Headlight") },
    AccessTo<int>(document, &LightDescription::Type));
  AddFrame(form, document, view);
  AddPlace(form, document);
  AddBrightness(form, document);
  form->AddColor(
    { QObject::tr("Diffuse colour"), QObject::tr("What matt surfaces reflect of it.") },
    AccessTo<Vector3>(document, &LightDescription::Diffuse));
  form->AddColor({ QObject::tr("Specular colour"), QObject::tr("The colour of its highlights.") },
    AccessTo<Vector3>(document, &LightDescription::Specular));
  form->AddColor({ QObject::tr("Ambient colour"),
                   QObject::tr("What it gives to everything, shadowed or not; black for none.") },
    AccessTo<Vector3>(document, &LightDescription::Ambient));
  AddShadow(form, document);
  AddShadowDetails(form, document);
  AddCone(form, document);
}

}
