#include "RenderingForm.h"

#include "PropertyForm.h"
#include "QualityLabel.h"
#include "SceneDocument.h"
#include "StepFigures.h"
#include "VolumeBox.h"

#include <QFileDialog>
#include <QObject>
#include <QPushButton>

#include <vtkImageData.h>

#include <algorithm>

namespace penumbra
{
namespace
{
template <typename Value, typename Member>
PropertyAccess<Value> AccessTo(Member MaterialDescription::*member)
{
  return { [=](const SceneDescription& scene)
    { return static_cast<Value>(scene.Material.*member); },
    [=](SceneDescription& scene, const Value& value)
    { scene.Material.*member = static_cast<Member>(value); } };
}

template <typename Value, typename Member>
PropertyAccess<Value> AccessToScene(Member SceneDescription::*member)
{
  return { [=](const SceneDescription& scene) { return static_cast<Value>(scene.*member); },
    [=](SceneDescription& scene, const Value& value)
    { scene.*member = static_cast<Member>(value); } };
}

PropertyForm::Condition WhenModel(std::initializer_list<ReflectionModel> models)
{
  const std::vector<ReflectionModel> list(models);
  return [list](const SceneDescription& scene)
  { return std::find(list.begin(), list.end(), scene.Material.Model) != list.end(); };
}

void AddReflection(PropertyForm* form)
{
  form->AddSlider({ QObject::tr("Ambient"),
                    QObject::tr("Light that is everywhere: it opens shadows and flattens depth.") },
    { 0.0, 1.0, 3 }, 1.0, AccessTo<double>(&MaterialDescription::Ambient));
  form->AddSlider({ QObject::tr("Diffuse"),
                    QObject::tr("How much matt reflection surfaces have: it shows their slope.") },
    { 0.0, 1.0, 3 }, 1.0, AccessTo<double>(&MaterialDescription::Diffuse));
  form->AddSlider({ QObject::tr("Specular"),
                    QObject::tr("How strong highlights are: it shows small relief, as if wet.") },
    { 0.0, 1.0, 3 }, 1.0, AccessTo<double>(&MaterialDescription::Specular));
}

void AddModelParameters(PropertyForm* form)
{
  using Model = ReflectionModel;
  form->AddSlider({ QObject::tr("Shininess"),
                    QObject::tr("The specular power: more makes highlights smaller and sharper.") },
    { 0.0, 1000.0, 1 }, 128.0, AccessTo<double>(&MaterialDescription::SpecularPower));
  form->ShowLastWhen(WhenModel({ Model::Phong, Model::BlinnPhong, Model::ReflectionMap }));
  form->AddSlider({ QObject::tr("Roughness"),
                    QObject::tr("How uneven the surface is in the small: more spreads highlights "
                                "(Ward) or flattens matt shading (Oren-Nayar).") },
    { 0.001, 10.0, 3 }, 1.0, AccessTo<double>(&MaterialDescription::Roughness));
  form->ShowLastWhen(WhenModel({ Model::OrenNayar, Model::Ward }));
  form->AddSlider({ QObject::tr("Roughness along"),
                    QObject::tr("Spread of highlights along the preferred direction.") },
    { 0.001, 10.0, 3 }, 1.0, AccessTo<double>(&MaterialDescription::RoughnessX));
  form->ShowLastWhen(WhenModel({ Model::WardAnisotropic }));
  form->AddSlider({ QObject::tr("Roughness across"),
                    QObject::tr("Spread of highlights across the preferred direction.") },
    { 0.001, 10.0, 3 }, 1.0, AccessTo<double>(&MaterialDescription::RoughnessY));
  form->ShowLastWhen(WhenModel({ Model::WardAnisotropic }));
  form->AddVector({ QObject::tr("Preferred direction"),
                    QObject::tr("The direction of the brush, in the volume's own frame.") },
    { -1000.0, 1000.0, 3 }, AccessTo<Vector3>(&MaterialDescription::PreferredDirection));
  form->ShowLastWhen(WhenModel({ Model::WardAnisotropic }));
  form->AddSlider({ QObject::tr("Facets' slope"),
                    QObject::tr("How steep the microscopic facets are: more spreads highlights.") },
    { 0.001, 10.0, 3 }, 1.0, AccessTo<double>(&MaterialDescription::Slope));
  form->ShowLastWhen(WhenModel({ Model::CookTorrance }));
  form->AddChoice(
    { QObject::tr("Facets' distribution"), QObject::tr("How the facets' slopes are distributed.") },
    { QObject::tr("Beckmann"), QObject::tr("Gaussian") },
    AccessTo<int>(&MaterialDescription::Distribution));
  form->ShowLastWhen(WhenModel({ Model::CookTorrance }));
  form->AddVector(
    { QObject::tr("Refraction"),
      QObject::tr("Index of refraction for red, green and blue: more reflects more.") },
    { 1.0, 1000.0, 3 }, AccessTo<Vector3>(&MaterialDescription::IndexOfRefraction));
  form->ShowLastWhen(WhenModel({ Model::CookTorrance }));
}

void AddSurroundings(PropertyForm* form, SceneDocument* document)
{
  auto* const choose = new QPushButton(QObject::tr("Reflect an image..."), form);
  choose->setToolTip(QObject::tr("Let surfaces mirror surroundings: an equirectangular image"));
  QObject::connect(choose, &QPushButton::clicked, form,
    [=]
    {
      const QString file = QFileDialog::getOpenFileName(form, QObject::tr("Surroundings"),
        QString(), QObject::tr("Images (*.png *.jpg *.jpeg *.hdr *.tif *.tiff)"));
      if (!file.isEmpty())
      {
        document->Edit(QObject::tr("surroundings"),
          [=](SceneDescription& scene)
          {
            scene.Material.EnvironmentMap = { std::filesystem::u8path(file.toStdString()) };
            scene.Material.Model = ReflectionModel::ReflectionMap;
          });
      }
    });
  form->AddWidget(choose);
}

// 0 to 100, in equal steps of the typical error.
PropertyAccess<double> QualityAccess(SceneDocument* document)
{
  const auto smallest = [document] { return SmallestSpacing(document->GetVoxels().Volume); };
  const double most = TypicalError(LongestStep);
  const double least = TypicalError(ShortestStep);
  return { [=](const SceneDescription& scene)
    {
      const double error = TypicalError(*scene.SampleDistance / smallest());
      return std::clamp(100.0 * (most - error) / (most - least), 0.0, 100.0);
    },
    [=](SceneDescription& scene, const double& quality)
    {
      const double error = most - quality / 100.0 * (most - least);
      scene.SampleDistance = StepOfTypicalError(error) * smallest();
      scene.Shadows.SampleDistance = 2.0 * *scene.SampleDistance;
    } };
}

void AddSteps(PropertyForm* form, SceneDocument* document, VolumeView* view)
{
  form->AddSlider({ QObject::tr("Quality"),
                    QObject::tr("Length of the steps along rays, so that equal moves of the slider "
                                "change the error equally. More is slower.") },
    { 0.0, 100.0, 1 }, 100.0, QualityAccess(document));
  form->AddWidget(new QualityLabel(document, view, form));
  form->AddNumber({ QObject::tr("Step"),
                    QObject::tr("Distance between samples along a ray, in the volume's lengths.") },
    { 1e-4, 1e4, 4 },
    { [](const SceneDescription& scene) { return *scene.SampleDistance; },
      [](SceneDescription& scene, const double& step) { scene.SampleDistance = step; } });
  form->AddNumber(
    { QObject::tr("Shadow step"),
      QObject::tr("Distance between samples on the way to a light; longer is faster.") },
    { 1e-4, 1e4, 4 },
    { [](const SceneDescription& scene) { return *scene.Shadows.SampleDistance; },
      [](SceneDescription& scene, const double& step) { scene.Shadows.SampleDistance = step; } });
}
}

//------------------------------------------------------------------------------
void FillMaterialForm(PropertyForm* form, SceneDocument* document)
{
  form->AddChoice({ QObject::tr("Reflection"),
                    QObject::tr("How surfaces reflect: Phong and Blinn-Phong are plain, Oren-Nayar "
                                "is matt like clay, Ward and Cook-Torrance are measured metals and "
                                "glazes.") },
    { QObject::tr("Phong"), QObject::tr("Blinn-Phong"), QObject::tr("Oren-Nayar"),
      QObject::tr("Ward"), QObject::tr("Ward, anisotropic"), QObject::tr("Cook-Torrance"),
      QObject::tr("Reflection map") },
    AccessTo<int>(&MaterialDescription::Model));
  AddReflection(form);
  AddModelParameters(form);
  AddSurroundings(form, document);
}

//------------------------------------------------------------------------------
void FillRenderingForm(PropertyForm* form, SceneDocument* document, VolumeView* view)
{
  form->AddHeading(QObject::tr("Light and shadow"));
  form->AddChoice({ QObject::tr("Renderer"),
                    QObject::tr("Penumbra casts shadows; VTK's own ray caster does not.") },
    { QObject::tr("Penumbra"), QObject::tr("VTK") },
    { [](const SceneDescription& scene)
      { return scene.Renderer == RendererChoice::StockMapper ? 1 : 0; },
      [](SceneDescription& scene, const int& renderer) {
        scene.Renderer = renderer == 1 ? RendererChoice::StockMapper : RendererChoice::Penumbra;
      } });
  form->AddChoice({ QObject::tr("Light transport"),
                    QObject::tr("Single scattering is lit matter. The others show matter as if it "
                                "glowed or only took light away; lights then do not count.") },
    { QObject::tr("Absorption"), QObject::tr("Emission"), QObject::tr("Absorption and emission"),
      QObject::tr("Single scattering (lit)") },
    AccessToScene<int>(&SceneDescription::Optics));
  form->AddChoice({ QObject::tr("Shadows by"),
                    QObject::tr("Automatic takes the fastest whose error is small. Rays are exact. "
                                "The others keep shadows between pictures, so that turning is "
                                "faster: a volume with a shadow per voxel, a map of the first "
                                "surface for hard shadows, or maps with depth for soft ones: by a "
                                "few nodes, or by layers.") },
    { QObject::tr("Automatic"), QObject::tr("Rays"), QObject::tr("Shadow volume"),
      QObject::tr("Shadow map"), QObject::tr("Deep shadow map"),
      QObject::tr("Opacity shadow map") },
    { [](const SceneDescription& scene) { return static_cast<int>(scene.Shadows.Technique); },
      [](SceneDescription& scene, const int& choice)
      { scene.Shadows.Technique = static_cast<TechniqueChoice>(choice); } });
  form->AddSlider({ QObject::tr("Tolerated error"),
                    QObject::tr("How far shadows may be off in grey levels of 255, as a root mean "
                                "square; more is faster.") },
    { 0.0, 255.0, 2 }, 4.0,
    { [](const SceneDescription& scene) { return scene.Shadows.Tolerance; },
      [](SceneDescription& scene, const double& error) { scene.Shadows.Tolerance = error; } });
  form->ShowLastWhen(
    [](const SceneDescription& scene) { return scene.Shadows.Technique == TechniqueChoice::Auto; });
  form->AddSwitch(
    { QObject::tr("Lit from both sides"), QObject::tr("Whether the back of surfaces is lit too.") },
    AccessToScene<bool>(&SceneDescription::TwoSidedLighting));
  form->AddColor({ QObject::tr("Background"), QObject::tr("The colour behind the volume.") },
    { [](const SceneDescription& scene) { return scene.Image.Background; },
      [](SceneDescription& scene, const Vector3& color) { scene.Image.Background = color; } });
  form->AddHeading(QObject::tr("Quality"));
  AddSteps(form, document, view);
  form->AddChoice({ QObject::tr("Gradient"),
                    QObject::tr("How slopes are estimated: central is good, forward and backward "
                                "are cheap, Sobel smooths noise and costs most.") },
    { QObject::tr("Central"), QObject::tr("Forward"), QObject::tr("Backward"),
      QObject::tr("Sobel") },
    AccessToScene<int>(&SceneDescription::Gradient));
}

}
