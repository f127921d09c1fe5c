#include "StabilityStudy.h"

#include "StudyScenes.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace penumbra
{
namespace
{
namespace fs = std::filesystem;

constexpr double TimeLimit = 60.0;
// What alpha a picture has to reach so that something is seen, and stays below where nothing is.
constexpr float Seen = 0.02f;
constexpr float Unseen = 0.005f;

float LargestAlpha(const StudyPicture& picture)
{
  float largest = 0.0f;
  for (std::size_t at = 3; at < picture.Values.size(); at += 4)
  {
    largest = std::max(largest, picture.Values[at]);
  }
  return largest;
}

std::string Rounded(double value)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << value;
  return text.str();
}

StabilityOutcome JudgePicture(
  const StudyPicture& picture, const RenderResult& reference, double bound)
{
  const bool finite = std::all_of(picture.Values.begin(), picture.Values.end(),
    [](float value) { return std::isfinite(value) && value >= 0.0f && value <= 1.0f; });
  if (!finite)
  {
    return { false, "values that are not between 0 and 1" };
  }
  if (!reference.Picture)
  {
    return { false, "no reference: " + reference.Error };
  }
  if (LargestAlpha(*reference.Picture) > Seen && LargestAlpha(picture) < Unseen)
  {
    return { false, "blank" };
  }
  const PictureError error = CompareWithReference(picture, *reference.Picture);
  return { error.RootMeanSquare <= bound, "RMSE " + Rounded(error.RootMeanSquare) };
}

StabilityOutcome Judge(
  const StabilityCase& stability, const RenderResult& result, const RenderResult& reference)
{
  if (stability.Bound < 0.0)
  {
    return { result.End == RenderEnd::Refused,
      result.End == RenderEnd::Refused ? "refused" : NameOf(result.End) };
  }
  if (result.End != RenderEnd::Done)
  {
    return { false, NameOf(result.End) + (result.Error.empty() ? "" : ": " + result.Error) };
  }
  return JudgePicture(*result.Picture, reference, stability.Bound);
}

std::string ExpectationOf(const StabilityCase& stability)
{
  std::ostringstream text;
  text << "within " << stability.Bound << " of 255";
  return stability.Bound < 0.0 ? "refused" : (stability.Bound >= 255.0 ? "a picture" : text.str());
}

int CountRight(const std::vector<StabilityRow>& rows, StabilityOutcome StabilityRow::*outcome)
{
  return static_cast<int>(std::count_if(rows.begin(), rows.end(),
    [outcome](const StabilityRow& row) { return (row.*outcome).IsRight; }));
}

std::string Quoted(const std::string& text)
{
  std::string quoted = "\"";
  for (const char letter : text)
  {
    quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  }
  return quoted + "\"";
}
}

//------------------------------------------------------------------------------
std::vector<StabilityRow> RunStabilityStudy(const std::vector<StabilityCase>& cases,
  const RenderProgram& program, const fs::path& folder, const std::function<void(double)>& progress)
{
  WriteStabilityVolumes(folder);
  std::vector<StabilityRow> rows;
  const fs::path scene = folder / "case.json";
  const auto run = [&](const std::string& renderer) {
    return program.Run({ scene, { "renderer=" + renderer }, 0, TimeLimit });
  };
  for (const StabilityCase& stability : cases)
  {
    WriteText(scene, stability.Scene.dump(1) + "\n");
    const RenderResult reference = stability.Bound < 0.0 ? RenderResult{} : run("reference");
    rows.push_back({ stability.Name, ExpectationOf(stability),
      Judge(stability, run("penumbra"), reference), Judge(stability, run("vtk"), reference) });
    if (progress)
    {
      progress(static_cast<double>(rows.size()) / static_cast<double>(cases.size()));
    }
  }
  return rows;
}

//------------------------------------------------------------------------------
std::string WriteStabilityCsv(const std::vector<StabilityRow>& rows)
{
  std::string text = "case,expected,penumbra right,penumbra,vtk right,vtk\n";
  for (const StabilityRow& row : rows)
  {
    text += Quoted(row.Case) + "," + Quoted(row.Expected) + "," +
      (row.Penumbra.IsRight ? "yes," : "no,") + Quoted(row.Penumbra.Words) + "," +
      (row.StockMapper.IsRight ? "yes," : "no,") + Quoted(row.StockMapper.Words) + "\n";
  }
  return text;
}

//------------------------------------------------------------------------------
std::string WriteStabilityJson(const std::vector<StabilityRow>& rows, const std::string& command)
{
  nlohmann::ordered_json json = { { "penumbra", PENUMBRA_VERSION }, { "command", command } };
  for (const StabilityRow& row : rows)
  {
    json["cases"].push_back({ { "case", row.Case }, { "expected", row.Expected },
      { "penumbra", { { "right", row.Penumbra.IsRight }, { "outcome", row.Penumbra.Words } } },
      { "vtk", { { "right", row.StockMapper.IsRight }, { "outcome", row.StockMapper.Words } } } });
  }
  return json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

//------------------------------------------------------------------------------
std::string WriteStabilityMarkdown(const std::vector<StabilityRow>& rows)
{
  std::string text = SummarizeStability(rows) +
    "\n\n| case | expected | penumbra | VTK's mapper |\n|---|---|---|---|\n";
  const auto words = [](const StabilityOutcome& outcome)
  { return outcome.IsRight ? outcome.Words : "**" + outcome.Words + "**"; };
  for (const StabilityRow& row : rows)
  {
    text += "| " + row.Case + " | " + row.Expected + " | " + words(row.Penumbra) + " | " +
      words(row.StockMapper) + " |\n";
  }
  return text;
}

//------------------------------------------------------------------------------
std::string SummarizeStability(const std::vector<StabilityRow>& rows)
{
  return std::to_string(CountRight(rows, &StabilityRow::Penumbra)) + " of " +
    std::to_string(rows.size()) + " extreme cases are right; with VTK's own mapper " +
    std::to_string(CountRight(rows, &StabilityRow::StockMapper)) + " are";
}

}
