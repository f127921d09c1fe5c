#include "RenderCommand.h"

#include "BareVolume.h"
#include "Frames.h"
#include "InputError.h"
#include "OutputFile.h"
#include "Picture.h"
#include "Process.h"
#include "ProgressLine.h"
#include "RenderingError.h"
#include "Report.h"
#include "SceneDefaults.h"
#include "SceneFile.h"
#include "SceneRendering.h"
#include "SceneWriter.h"
#include "vtkMessageCollector.h"

#include <vtkIlluminatedVolumeMapper.h>
#include <vtkImageData.h>
#include <vtkRenderWindow.h>

#include <algorithm>
#include <iostream>
#include <utility>

namespace penumbra
{
namespace
{
namespace fs = std::filesystem;

void TellProgress(const std::string& what)
{
  if (IsTerminalAtStandardError())
  {
    std::cerr << what << std::endl;
  }
}

bool AreSame(const fs::path& left, const fs::path& right)
{
  std::error_code ignored;
  const auto whole = [&ignored](const fs::path& path)
  { return fs::weakly_canonical(fs::absolute(path), ignored); };
  // The second also knows of letters that the file system does not tell apart.
  return whole(left) == whole(right) || fs::equivalent(left, right, ignored);
}

// The files that a command writes; each is refused before any work where it cannot be written.
struct CommandOutputs
{
  explicit CommandOutputs(const RenderCommand& command)
  {
    if (command.Output)
    {
      this->Format = FormatOf(*command.Output);
    }
    this->Open("--output", command.Output, this->Picture);
    this->OpenJson("--report", command.Report, this->Report);
    this->OpenJson("--save-scene", command.SavedScene, this->Scene);
  }

  std::vector<OutputFile*> All()
  {
    std::vector<OutputFile*> files;
    for (auto* file : { &this->Picture, &this->Report, &this->Scene })
    {
      if (*file)
      {
        files.push_back(&**file);
      }
    }
    return files;
  }

  void RefuseToOverwrite(const fs::path& input)
  {
    for (OutputFile* file : this->All())
    {
      RefuseToOverwrite(*file, input);
    }
  }

  // A scene may be saved over itself.
  void RefuseToOverwriteScene(const fs::path& input)
  {
    for (auto* file : { &this->Picture, &this->Report })
    {
      if (*file)
      {
        RefuseToOverwrite(**file, input);
      }
    }
  }

  PictureFormat Format = PictureFormat::Png;
  std::optional<OutputFile> Picture;
  std::optional<OutputFile> Report;
  std::optional<OutputFile> Scene;

private:
  static void RefuseToOverwrite(const OutputFile& file, const fs::path& input)
  {
    if (AreSame(file.GetTarget(), input))
    {
      throw InputError(input.u8string() + " is read by this command and cannot be written too");
    }
  }

  void Open(
    const std::string& option, const std::optional<fs::path>& path, std::optional<OutputFile>& file)
  {
    if (!path)
    {
      return;
    }
    OutputFile opened(option, *path);
    for (OutputFile* other : this->All())
    {
      if (AreSame(other->GetTarget(), opened.GetTarget()))
      {
        throw InputError(option + " is " + path->u8string() + ", which is written to already");
      }
    }
    file.emplace(std::move(opened));
  }

  // No data file that a header names is called so, and none is written over by mistake.
  void OpenJson(
    const std::string& option, const std::optional<fs::path>& path, std::optional<OutputFile>& file)
  {
    this->Open(option, path, file);
    if (path && !IsSceneFile(*path))
    {
      throw InputError(
        option + " is " + path->u8string() + "; accepted: a name that ends in .json");
    }
  }
};

// Refuses what can be refused before the volume is read.
SceneDescription CheckCommandScene(
  const RenderCommand& command, const SceneSource& source, CommandOutputs& outputs)
{
  SceneDescription scene = source.Describe(PresetForChecking(source));
  if (command.Change)
  {
    CheckChange(*command.Change, scene.Lights.size());
  }
  outputs.RefuseToOverwrite(scene.Volume.File);
  outputs.RefuseToOverwriteScene(command.Input);
  if (scene.Volume.Mask)
  {
    outputs.RefuseToOverwrite(*scene.Volume.Mask);
  }
  return scene;
}

SceneVoxels ReadCommandVoxels(
  const RenderCommand& command, const VolumeDescription& volume, std::vector<std::string>& warnings)
{
  ProgressLine line("reading " + volume.File.u8string());
  const auto progress = [&line](double part)
  {
    line.Tell(part);
    return true;
  };
  return ReadVoxels(volume, { command.DicomParser, progress }, warnings);
}

void CollectWarnings(const std::vector<std::string>& more, std::vector<std::string>& warnings)
{
  for (const std::string& warning : more)
  {
    if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end())
    {
      warnings.push_back(warning);
    }
  }
}

void RefuseReadingErrors(vtkMessageCollector* messages)
{
  if (!messages->GetErrors().empty())
  {
    throw InputError(messages->GetErrors().front());
  }
}

std::string TextOf(const SceneDescription& scene, const fs::path& file)
{
  return WriteScene(scene, fs::absolute(file).parent_path());
}

void WriteOutputs(CommandOutputs& outputs, const RenderedFrames& frames,
  const std::string& savedScene, vtkImageData* volume, vtkIlluminatedVolumeMapper* mapper,
  const ReportTexts& texts)
{
  if (outputs.Picture)
  {
    outputs.Picture->Write(EncodePicture(frames.Picture, outputs.Format));
  }
  if (outputs.Report)
  {
    outputs.Report->Write(WriteReport(frames, volume, mapper, texts));
  }
  if (outputs.Scene)
  {
    outputs.Scene->Write(savedScene);
  }
  for (OutputFile* file : outputs.All())
  {
    file->Commit();
  }
}
}

//------------------------------------------------------------------------------
void Execute(const RenderCommand& command, vtkMessageCollector* messages)
{
  CommandOutputs outputs(command);
  const SceneSource source(command.Input, command.Settings, command.Preset);
  SceneDescription scene = CheckCommandScene(command, source, outputs);

  std::vector<std::string> warnings;
  SceneVoxels voxels = ReadCommandVoxels(command, scene.Volume, warnings);
  RefuseReadingErrors(messages);
  std::vector<std::string> choices;
  if (source.IsBareVolume())
  {
    scene = ArrangeBareVolume(source, voxels.Volume, choices);
  }
  ResolveScene(scene, voxels.Volume);
  voxels.Environment = ReadEnvironmentImages(scene.Material);
  RefuseReadingErrors(messages);
  const std::string savedScene = command.SavedScene ? TextOf(scene, *command.SavedScene) : "";

  SceneRendering rendering(scene, voxels);
  TellProgress("rendering");
  const auto checkFrame = [&](int frame)
  {
    if (!messages->GetErrors().empty())
    {
      throw RenderingError(messages->GetErrors().front());
    }
    if (command.NumberOfFrames > 0)
    {
      TellProgress("rendered frame " + std::to_string(frame) + " of " +
        std::to_string(command.NumberOfFrames));
    }
  };
  vtkSmartPointer<vtkRenderWindow> window;
  FrameDrawing drawing;
  if (scene.Renderer == RendererChoice::Reference)
  {
    drawing = DrawReference(scene, voxels, rendering);
  }
  else
  {
    window = MakeWindow(rendering, scene.Image.Size);
    drawing = DrawInWindow(window);
  }
  const RenderedFrames frames = RenderFrames(rendering, drawing, command, checkFrame);

  vtkIlluminatedVolumeMapper* mapper =
    scene.Renderer == RendererChoice::Reference ? nullptr : rendering.GetIlluminatedMapper();
  CollectWarnings(rendering.GetWarnings(), warnings);
  if (mapper)
  {
    CollectWarnings(mapper->GetMessages(), warnings);
  }
  CollectWarnings(messages->GetWarnings(), warnings);
  WriteOutputs(outputs, frames, savedScene, voxels.Volume, mapper, { choices, warnings });
  for (const std::string& warning : warnings)
  {
    std::cerr << "warning: " << warning << "\n";
  }
  if (command.Explain)
  {
    std::cout << ExplainRequirements(mapper);
  }
}

}
