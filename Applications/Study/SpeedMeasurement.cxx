#include "SpeedMeasurement.h"

#include "InputError.h"
#include "RenderingError.h"
#include "SceneWriter.h"
#include "SpeedRendering.h"
#include "SpeedRenderingReport.h"
#include "SpeedTimes.h"
#include "SpeedVoxels.h"
#include "StudyScenes.h"

#include <vtkImageData.h>
#include <vtkOutputWindow.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>

namespace penumbra
{
namespace
{
// Processor seconds; frames that take longer are left out unless all is asked for.
constexpr double LongestFrame = 20.0;
constexpr std::size_t VariantsPerStockFrame = 3;

// VTK's messages go to each rendering in turn meanwhile.
class MessagesKept
{
public:
  MessagesKept()
    : Window(vtkOutputWindow::GetInstance())
  {
  }
  ~MessagesKept() { vtkOutputWindow::SetInstance(this->Window); }
  MessagesKept(const MessagesKept&) = delete;
  MessagesKept& operator=(const MessagesKept&) = delete;

private:
  vtkSmartPointer<vtkOutputWindow> Window;
};

struct Drawn
{
  SpeedVariant Variant;
  SpeedRow Row;
  std::unique_ptr<SpeedRendering> Rendering;
  StudyPicture Picture;
  SpeedTimes Times;
};

// All pixels are the same.
bool IsBlank(const StudyPicture& picture)
{
  constexpr std::ptrdiff_t channels = 4;
  return std::equal(
    picture.Values.begin() + channels, picture.Values.end(), picture.Values.begin());
}

class CellMeasurement
{
public:
  CellMeasurement(const SpeedCell& cell, const SpeedMeasuring& measuring)
    : Cell(cell)
    , Measuring(measuring)
    , Voxels(ReadSpeedVoxels(cell, measuring.DicomParser))
  {
  }

  SpeedCellResult Run()
  {
    for (const SpeedVariant& variant : GetSpeedVariants(this->Cell, this->Measuring.Full))
    {
      this->Attempt(variant.Name, [&] { this->DrawFirst(variant); });
    }
    for (Drawn& drawn : this->All)
    {
      this->Attempt(drawn.Variant.Name, [&] { this->Judge(drawn); });
    }
    for (int round = 0; round < UsualRounds; ++round)
    {
      this->TimeRound();
    }
    for (int round = UsualRounds; round < RoundsOfFourLights; ++round)
    {
      this->TimeFourLights();
    }
    this->AddRows(this->SecondsOfStockUnlit());
    return this->Result;
  }

private:
  // A variant that fails is a note, and the others go on.
  template <class Task>
  void Attempt(const std::string& variant, const Task& task)
  {
    try
    {
      task();
    }
    catch (const RenderingError& error)
    {
      this->Note(variant + " failed: " + error.what());
    }
  }

  void Note(const std::string& text)
  {
    this->Result.Notes.push_back(NameOfCell(this->Cell) + ": " + text);
  }

  std::unique_ptr<SpeedRendering> Render(const SpeedRequest& request) const
  {
    return std::make_unique<SpeedRendering>(
      DescribeSpeedScene(this->Cell, request, this->Voxels), this->Voxels);
  }

  void DrawFirst(const SpeedVariant& variant)
  {
    Drawn drawn;
    drawn.Variant = variant;
    drawn.Row = this->MakeRow(variant);
    drawn.Rendering = this->Render(variant.Request);
    drawn.Row.First = drawn.Rendering->Draw().CpuSeconds;
    if (drawn.Row.First > LongestFrame && !this->Measuring.Full)
    {
      this->Note(variant.Name + " is left out, as a frame takes about " +
        std::to_string(static_cast<int>(drawn.Row.First)) + " s; --full takes it");
      return;
    }
    drawn.Picture = drawn.Rendering->TakePicture();
    for (const std::string& warning : drawn.Rendering->GetWarnings())
    {
      this->Note(variant.Name + ": " + warning);
    }
    this->All.push_back(std::move(drawn));
  }

  SpeedRow MakeRow(const SpeedVariant& variant) const
  {
    const int* size = this->Voxels.Volume->GetDimensions();
    SpeedRow row;
    row.Scene = this->Cell.Scene.Name;
    row.HasBounds = this->Cell.Scene.HasBounds;
    row.IsOwnSize = this->Cell.Edge == 0;
    row.Edge = *std::max_element(size, size + 3);
    row.Voxels = this->Voxels.Volume->GetNumberOfPoints();
    row.Image = this->Cell.Image;
    row.Lights = this->Cell.Lights;
    row.Variant = variant.Name;
    row.Resolution =
      DescribeSpeedScene(this->Cell, variant.Request, this->Voxels).Shadows.Resolution;
    return row;
  }

  // How right the picture is, what it took and what skipping changes.
  void Judge(Drawn& drawn)
  {
    const nlohmann::json report = drawn.Rendering->Report();
    this->Result.OpenGLRenderer = report["openglRenderer"];
    ReadReport(report, drawn.Row);
    if (drawn.Variant.Truth)
    {
      drawn.Row.Error = CompareWithReference(drawn.Picture, this->TruthOf(*drawn.Variant.Truth));
    }
    if (this->Cell.IsPlain())
    {
      drawn.Row.ChangedBySkipping = this->Cell.Scene.HasBounds && SkipsEmptySpace(report)
        ? this->ChangedBySkipping(drawn)
        : std::nullopt;
      drawn.Row.PeakMemory = this->PeakMemoryOf(drawn.Variant);
    }
  }

  const StudyPicture& TruthOf(const SpeedRequest& request)
  {
    const std::string name = std::accumulate(
      request.Settings.begin(), request.Settings.end(), std::to_string(request.Step));
    const auto known = this->Truths.find(name);
    if (known != this->Truths.end())
    {
      return known->second;
    }
    const auto rendering = this->Render(request);
    rendering->Draw();
    return this->Truths[name] = rendering->TakePicture();
  }

  std::optional<double> ChangedBySkipping(const Drawn& drawn) const
  {
    SpeedRequest request = drawn.Variant.Request;
    request.Settings.push_back("skipEmptySpace=false");
    const auto rendering = this->Render(request);
    rendering->Draw();
    return PartThatDiffers(drawn.Picture, rendering->TakePicture());
  }

  std::optional<std::uint64_t> PeakMemoryOf(const SpeedVariant& variant) const
  {
    if (!this->Measuring.Program)
    {
      return std::nullopt;
    }
    const std::filesystem::path& folder = this->Measuring.Program->GetWorkFolder();
    const std::filesystem::path file = folder / "scene.json";
    SceneDescription scene = DescribeSpeedScene(this->Cell, variant.Request, this->Voxels);
    // What auto keeps depends on how many pixels there are, what others keep does not.
    if (variant.Name != "auto")
    {
      scene.Image.Size = { 16, 16 };
    }
    WriteText(file, WriteScene(scene, folder));
    const RenderResult result = this->Measuring.Program->Run({ file });
    return result.End == RenderEnd::Done
      ? std::optional<std::uint64_t>(result.Report["peakMemoryBytes"])
      : std::nullopt;
  }

  // The stock mapper's unlit frame comes again and again, as all others are multiples of it.
  void TimeRound()
  {
    for (std::size_t at = 0; at < this->All.size(); ++at)
    {
      if (at % VariantsPerStockFrame == 0)
      {
        this->Time(this->All.front());
      }
      if (at > 0)
      {
        this->Time(this->All[at]);
      }
    }
  }

  void TimeFourLights()
  {
    for (Drawn& drawn : this->All)
    {
      if (drawn.Variant.Rounds == RoundsOfFourLights)
      {
        this->Time(drawn);
      }
    }
  }

  void Time(Drawn& drawn)
  {
    this->Attempt(
      drawn.Variant.Name, [&] { drawn.Times.AddRound(drawn.Variant, *drawn.Rendering); });
  }

  // What all others are multiples of. 0 where there is nothing to compare with.
  double SecondsOfStockUnlit()
  {
    if (this->All.empty() || this->All.front().Variant.Name != StockUnlit)
    {
      return 0.0;
    }
    const Drawn& stock = this->All.front();
    if (IsBlank(stock.Picture))
    {
      this->Note("VTK's own mapper draws nothing of it, so that there are no multiples");
      return 0.0;
    }
    SpeedRow row;
    stock.Times.PutInto(row);
    return row.CpuSeconds;
  }

  void AddRows(double unlit)
  {
    for (Drawn& drawn : this->All)
    {
      SpeedRow& row = drawn.Row;
      drawn.Times.PutInto(row);
      row.Relative = unlit > 0.0 ? row.CpuSeconds / unlit : 0.0;
      this->Result.Rows.push_back(row);
    }
  }

  SpeedCell Cell;
  const SpeedMeasuring& Measuring;
  MessagesKept Messages;
  SceneVoxels Voxels;
  std::vector<Drawn> All;
  std::map<std::string, StudyPicture> Truths;
  SpeedCellResult Result;
};
}

//------------------------------------------------------------------------------
SpeedCellResult MeasureSpeedCell(const SpeedCell& cell, const SpeedMeasuring& measuring)
{
  try
  {
    return CellMeasurement(cell, measuring).Run();
  }
  catch (const InputError& error)
  {
    return { {}, { NameOfCell(cell) + " is left out: " + error.what() }, {} };
  }
}

//------------------------------------------------------------------------------
std::string NameOfCell(const SpeedCell& cell)
{
  return cell.Scene.Name + (cell.Edge > 0 ? ", " + std::to_string(cell.Edge) + " voxels" : "") +
    ", " + std::to_string(cell.Image) + " pixels, " + std::to_string(cell.Lights) +
    (cell.Lights > 1 ? " lights" : " light");
}

}
