#include "SceneDocument.h"

#include "InputError.h"
#include "OutputFile.h"
#include "SceneEdit.h"
#include "SceneFile.h"
#include "SceneParser.h"
#include "SceneWriter.h"

#include <nlohmann/json.hpp>

#include <vtkImageData.h>

#include <algorithm>

namespace penumbra
{
namespace
{
// What is compared and checked is what would be saved.
std::string TextOf(const SceneDescription& scene)
{
  return WriteScene(scene, scene.Volume.File.parent_path());
}

// The selected element of a list that may have become shorter; of an empty one: -1.
template <typename List>
int NearestOf(const List& list, int selected)
{
  const int count = static_cast<int>(list.size());
  return std::clamp(selected, std::min(0, count - 1), count - 1);
}
}

//------------------------------------------------------------------------------
SceneDocument::SceneDocument(QObject* parent)
  : QObject(parent)
{
}

//------------------------------------------------------------------------------
void SceneDocument::Open(const OpenedScene& opened)
{
  this->History.clear();
  this->Environments.clear();
  this->OpenedFile = opened.File;
  this->SceneFile.reset();
  if (IsSceneFile(opened.File))
  {
    this->SceneFile = opened.File;
  }
  this->Voxels = opened.Voxels;
  this->Scene = std::make_shared<const SceneDescription>(opened.Scene);
  this->SceneAsOpened = this->Scene;
  this->SelectedLight = this->Scene->Lights.empty() ? -1 : 0;
  this->SelectedPlane = this->Scene->ClippingPlanes.empty() ? -1 : 0;
  emit this->opened();
  emit this->changed();
  emit this->fileChanged();
  emit this->lightSelected(this->SelectedLight);
}

//------------------------------------------------------------------------------
QString SceneDocument::GetName() const
{
  const std::filesystem::path file = this->SceneFile.value_or(this->OpenedFile);
  return QString::fromStdString(file.filename().u8string());
}

//------------------------------------------------------------------------------
QString SceneDocument::Edit(
  const QString& text, const std::function<void(SceneDescription&)>& change, const QString& gesture)
{
  if (!this->IsOpen())
  {
    return QString();
  }
  const auto edited = std::make_shared<SceneDescription>(*this->Scene);
  try
  {
    change(*edited);
    const std::string after = TextOf(*edited);
    if (after == TextOf(*this->Scene))
    {
      return QString();
    }
    ParseScene(ParseJson(after), edited->Volume.File.parent_path());
    this->FindEnvironment(edited->Material);
  }
  catch (const InputError& error)
  {
    emit this->changed(); // so that what was entered is shown no longer
    const QString reason = QString::fromUtf8(error.what());
    emit this->refused(reason);
    return reason;
  }
  this->History.push(new SceneEdit(
    text, gesture, this->Scene, edited, [this](const SharedScene& scene) { this->Show(scene); }));
  return QString();
}

//------------------------------------------------------------------------------
void SceneDocument::Show(const SharedScene& scene)
{
  // The camera is no step of the history.
  const auto shown = std::make_shared<SceneDescription>(*scene);
  shown->Camera = this->Scene->Camera;
  shown->Image.Size = this->Scene->Image.Size;
  this->Scene = shown;
  this->Voxels.Environment = this->FindEnvironment(scene->Material);
  this->SelectedLight = NearestOf(scene->Lights, this->SelectedLight);
  this->SelectedPlane = NearestOf(scene->ClippingPlanes, this->SelectedPlane);
  emit this->changed();
}

//------------------------------------------------------------------------------
const EnvironmentImages& SceneDocument::FindEnvironment(const MaterialDescription& material)
{
  static const EnvironmentImages none;
  if (material.Model != ReflectionModel::ReflectionMap)
  {
    return none;
  }
  const auto found = this->Environments.find(material.EnvironmentMap);
  return found != this->Environments.end()
    ? found->second
    : this->Environments.emplace(material.EnvironmentMap, ReadEnvironmentImages(material))
        .first->second;
}

//------------------------------------------------------------------------------
void SceneDocument::SetView(const CameraDescription& camera, const std::array<int, 2>& size)
{
  const auto scene = std::make_shared<SceneDescription>(*this->Scene);
  scene->Camera = camera;
  scene->Image.Size = size;
  this->Scene = scene;
}

//------------------------------------------------------------------------------
void SceneDocument::Save(const std::filesystem::path& file)
{
  OutputFile output("scene", file);
  output.Write(WriteScene(*this->Scene, std::filesystem::absolute(file).parent_path()));
  output.Commit();
  this->SceneFile = file;
  this->History.setClean();
  emit this->fileChanged();
}

//------------------------------------------------------------------------------
void SceneDocument::SelectLight(int light)
{
  if (light != this->SelectedLight)
  {
    this->SelectedLight = light;
    emit this->lightSelected(light);
  }
}

//------------------------------------------------------------------------------
void SceneDocument::SelectPlane(int plane)
{
  if (plane != this->SelectedPlane)
  {
    this->SelectedPlane = plane;
    emit this->planeSelected(plane);
  }
}

}
