#include "SpeedStudy.h"

#include "StudyLog.h"

#include <vtkVersion.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace penumbra
{
namespace
{
namespace fs = std::filesystem;
using Json = nlohmann::json;

fs::path LogOf(const fs::path& folder)
{
  return folder / "speed-measurements.jsonl";
}

// Measurements of other versions do not go together.
std::string Stamp()
{
  return "1, " PENUMBRA_VERSION ", VTK " + std::string(vtkVersion::GetVTKVersion());
}

std::string KeyOf(const SpeedCell& cell, bool full)
{
  std::ifstream stream(cell.Scene.File, std::ios::binary);
  const std::string scene{ std::istreambuf_iterator<char>(stream),
    std::istreambuf_iterator<char>() };
  return NameOfCell(cell) + (full ? ", full, " : ", ") +
    std::to_string(std::hash<std::string>()(scene));
}

Json ToJson(const SpeedCellResult& cell)
{
  return { { "rows", cell.Rows }, { "notes", cell.Notes }, { "opengl", cell.OpenGLRenderer } };
}

SpeedCellResult ParseCell(const Json& json)
{
  return { json.at("rows").get<std::vector<SpeedRow>>(),
    json.at("notes").get<std::vector<std::string>>(), json.at("opengl") };
}

SpeedCellResult MeasureOnce(const SpeedCell& cell, const SpeedMeasuring& measuring, StudyLog& log)
{
  const std::string key = KeyOf(cell, measuring.Full);
  if (const Json* known = log.Find(key))
  {
    return ParseCell(*known);
  }
  const SpeedCellResult result = MeasureSpeedCell(cell, measuring);
  log.Add(key, ToJson(result));
  return result;
}
}

//------------------------------------------------------------------------------
SpeedStudyResult RunSpeedStudy(
  const std::vector<SpeedCell>& cells, const SpeedStudyOptions& options)
{
  StudyLog log(LogOf(options.Folder), Stamp());
  SpeedStudyResult result;
  for (std::size_t at = 0; at < cells.size(); ++at)
  {
    if (options.Progress)
    {
      options.Progress(static_cast<double>(at) / static_cast<double>(cells.size()));
    }
    const SpeedCellResult cell = MeasureOnce(cells[at], options.Measuring, log);
    result.Rows.insert(result.Rows.end(), cell.Rows.begin(), cell.Rows.end());
    result.Notes.insert(result.Notes.end(), cell.Notes.begin(), cell.Notes.end());
    result.OpenGLRenderer = cell.Rows.empty() ? result.OpenGLRenderer : cell.OpenGLRenderer;
  }
  if (result.Rows.empty())
  {
    throw std::runtime_error(
      "nothing could be drawn: " + (result.Notes.empty() ? "no scenes" : result.Notes.front()));
  }
  return result;
}

//------------------------------------------------------------------------------
void EndSpeedStudy(const fs::path& folder)
{
  std::error_code ignored;
  fs::remove(LogOf(folder), ignored);
}

}
