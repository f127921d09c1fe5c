#include "ErrorStudy.h"

#include "Median.h"

#include <vtkVersionMacros.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace penumbra
{
namespace
{
namespace fs = std::filesystem;
using Json = nlohmann::json;

const double Steps[] = { 4.0, 2.0, 1.0, 0.5, 0.25, 0.125, 0.0625 };
constexpr int Rounds = 3;
// Frames that take longer are timed once.
constexpr double LongFrame = 3.0;
// The grid ends before frames that would take longer, unless all of it is asked for.
constexpr double LongestFrame = 12.0;
constexpr double ReferenceTimeLimit = 3600.0;
// Half a step takes twice the samples, and each of its shadow rays twice the samples of its own.
constexpr double GrowthOfHalfStep = 4.0;

std::string TextOf(const fs::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
}

std::string Number(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

// A frame's times, as the log keeps them.
Json TimesOf(const Json& report)
{
  return { { "seconds", report["frameSeconds"][0] }, { "cpu", report["frameCpuSeconds"][0] } };
}

class Study
{
public:
  Study(const RenderProgram& program, const ErrorStudyOptions& options)
    : Program(program)
    , Options(options)
    , Log(options.Folder / "error-measurements.jsonl", "1")
  {
  }

  ErrorStudyResult Run(const std::vector<StudyScene>& scenes)
  {
    fs::create_directories(this->Options.Folder / "reference");
    this->Parts = static_cast<double>(
      scenes.size() * (1 + Rounds * GetStudyVariants().size() * std::size(Steps)));
    for (const StudyScene& scene : scenes)
    {
      this->AddScene(scene);
    }
    return this->Result;
  }

private:
  void AddScene(const StudyScene& scene)
  {
    this->Scene = scene;
    this->Identity =
      scene.Name + "/" + std::to_string(std::hash<std::string>()(TextOf(scene.File)));
    this->MakeReference();
    const std::size_t first = this->Result.Rows.size();
    for (const StudyVariant& variant : GetStudyVariants())
    {
      this->AddVariant(variant);
    }
    std::vector<double> unlit;
    for (int round = 0; round < Rounds; ++round)
    {
      this->TimeRound(first, round, unlit);
    }
    this->SetMedians(first, Median(unlit));
  }

  void Tell()
  {
    this->Done += 1.0;
    if (this->Options.Progress)
    {
      this->Options.Progress(std::min(this->Done / this->Parts, 1.0));
    }
  }

  void MakeReference()
  {
    const fs::path file = this->Options.Folder / "reference" / (this->Scene.Name + ".mha");
    const Json* known = this->Log.Find(this->Identity + "/reference");
    if (!known || !fs::exists(file))
    {
      const RenderResult result =
        this->Program.Run({ this->Scene.File, { "renderer=reference" }, 0, ReferenceTimeLimit });
      if (result.End != RenderEnd::Done)
      {
        throw std::runtime_error(
          this->Scene.Name + ": the reference " + NameOf(result.End) + ": " + result.Error);
      }
      WriteStudyPicture(*result.Picture, file);
      const Json& spacing = result.Report["volume"]["spacing"];
      known = &this->Log.Add(this->Identity + "/reference",
        { { "estimate", result.Report["reference"]["largestError"] },
          { "voxel", *std::min_element(spacing.begin(), spacing.end()) } });
    }
    this->Reference = ReadStudyPicture(file);
    this->Voxel = (*known)["voxel"];
    this->Result.ReferenceError[this->Scene.Name] = (*known)["estimate"];
    this->Tell();
  }

  void AddVariant(const StudyVariant& variant)
  {
    double lastCpu = 0.0;
    for (const double step : Steps)
    {
      if (!this->Options.Full && GrowthOfHalfStep * lastCpu > LongestFrame)
      {
        this->Note(variant.Name, step,
          "left out, as a frame would take about " +
            Number(std::round(GrowthOfHalfStep * lastCpu)) + " s; --full takes it");
        return;
      }
      const Json& picture = this->MakePicture(variant, step);
      if (picture.contains("failure"))
      {
        this->Note(variant.Name, step, picture["failure"]);
        return;
      }
      if (picture["coarser"])
      {
        this->Note(variant.Name, step, "is more samples than a fragment may take; the grid ends");
        return;
      }
      ErrorRow row{ this->Scene.Name, variant.Name, step, picture["error"].get<PictureError>(), 0,
        0, 0 };
      this->Result.Rows.push_back(row);
      this->Result.OpenGLRenderer = picture["opengl"];
      this->Result.VTKVersion = picture["vtk"];
      lastCpu = picture["cpu"];
      this->Tell();
    }
  }

  void Note(const std::string& variant, double step, const std::string& what)
  {
    this->Result.Notes.push_back(
      this->Scene.Name + ", " + variant + ", step " + Number(step) + ": " + what);
  }

  RenderRequest RequestOf(const std::vector<std::string>& settings, double step) const
  {
    RenderRequest request{ this->Scene.File, settings, 1, ReferenceTimeLimit };
    request.Settings.push_back("sampleDistance=" + Number(step * this->Voxel));
    request.Settings.push_back("shadows.sampleDistance=" + Number(2.0 * step * this->Voxel));
    return request;
  }

  std::string KeyOf(const std::string& variant, double step, int round) const
  {
    return this->Identity + "/" + variant + "/" + Number(step) + "/" + std::to_string(round);
  }

  // The first time that a row's scene is drawn gives its error too.
  const Json& MakePicture(const StudyVariant& variant, double step)
  {
    const std::string key = this->KeyOf(variant.Name, step, 0);
    if (const Json* known = this->Log.Find(key))
    {
      return *known;
    }
    const RenderResult result = this->Program.Run(this->RequestOf(variant.Settings, step));
    if (result.End != RenderEnd::Done)
    {
      return this->Log.Add(key, { { "failure", NameOf(result.End) + ": " + result.Error } });
    }
    Json measurement = TimesOf(result.Report);
    measurement["error"] = CompareWithReference(*result.Picture, this->Reference);
    measurement["opengl"] = result.Report["openglRenderer"];
    measurement["vtk"] = result.Report["vtkVersion"];
    const auto warnings = result.Report["warnings"].get<std::vector<std::string>>();
    measurement["coarser"] = std::any_of(warnings.begin(), warnings.end(),
      [](const std::string& warning)
      { return warning.find("longer than asked") != std::string::npos; });
    return this->Log.Add(key, measurement);
  }

  // Rows are timed in turn, so that what else the machine does is shared by all.
  void TimeRound(std::size_t first, int round, std::vector<double>& unlit)
  {
    if (const auto times = this->TimeFrame({ "renderer=vtk", "shade=false" }, "unlit", 1.0, round))
    {
      unlit.push_back((*times)["cpu"]);
    }
    for (std::size_t at = first; at < this->Result.Rows.size(); ++at)
    {
      ErrorRow& row = this->Result.Rows[at];
      std::vector<double>& cpu = this->Cpu[at];
      const bool takesLong = !cpu.empty() && cpu.front() > LongFrame;
      const auto times = takesLong
        ? std::nullopt
        : this->TimeFrame(this->SettingsOf(row.Variant), row.Variant, row.Step, round);
      if (times)
      {
        cpu.push_back((*times)["cpu"]);
        this->Seconds[at].push_back((*times)["seconds"]);
      }
      if (round > 0)
      {
        this->Tell();
      }
    }
  }

  std::optional<Json> TimeFrame(
    const std::vector<std::string>& settings, const std::string& name, double step, int round)
  {
    const std::string key = this->KeyOf(name, step, round);
    if (const Json* known = this->Log.Find(key))
    {
      return *known;
    }
    const RenderResult result = this->Program.Run(this->RequestOf(settings, step));
    if (result.End != RenderEnd::Done)
    {
      return std::nullopt;
    }
    return this->Log.Add(key, TimesOf(result.Report));
  }

  std::vector<std::string> SettingsOf(const std::string& name) const
  {
    const auto& variants = GetStudyVariants();
    return std::find_if(variants.begin(), variants.end(),
      [&](const StudyVariant& variant) { return variant.Name == name; })
      ->Settings;
  }

  void SetMedians(std::size_t first, double unlit)
  {
    for (std::size_t at = first; at < this->Result.Rows.size(); ++at)
    {
      ErrorRow& row = this->Result.Rows[at];
      row.CpuSeconds = Median(this->Cpu[at]);
      row.Seconds = Median(this->Seconds[at]);
      row.Relative = unlit > 0.0 ? row.CpuSeconds / unlit : 0.0;
    }
  }

  const RenderProgram& Program;
  const ErrorStudyOptions& Options;
  StudyLog Log;
  ErrorStudyResult Result;
  StudyScene Scene;
  std::string Identity;
  StudyPicture Reference;
  double Voxel = 1.0;
  std::map<std::size_t, std::vector<double>> Cpu;
  std::map<std::size_t, std::vector<double>> Seconds;
  double Done = 0.0;
  double Parts = 1.0;
};
}

//------------------------------------------------------------------------------
const std::vector<StudyVariant>& GetStudyVariants()
{
  static const std::vector<StudyVariant> variants = {
    { "penumbra rays", { "renderer=penumbra", "shadows.technique=rays" } },
    { "vtk", { "renderer=vtk" } },
    { "penumbra auto", { "renderer=penumbra", "shadows.technique=auto" } },
    { "penumbra volume", { "renderer=penumbra", "shadows.technique=volume" } },
    { "penumbra deep-map", { "renderer=penumbra", "shadows.technique=deep-map" } },
    { "penumbra opacity-map", { "renderer=penumbra", "shadows.technique=opacity-map" } },
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
    { "vtk scattering", { "renderer=vtk", "vtkScattering=1" } },
#endif
  };
  return variants;
}

//------------------------------------------------------------------------------
ErrorStudyResult RunErrorStudy(const std::vector<StudyScene>& scenes, const RenderProgram& program,
  const ErrorStudyOptions& options)
{
  return Study(program, options).Run(scenes);
}

}
