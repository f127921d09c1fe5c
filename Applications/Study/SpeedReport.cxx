#include "SpeedReport.h"

#include "SpeedBounds.h"
#include "StudyMachine.h"

#include <nlohmann/json.hpp>

#include <vtkVersion.h>

#include <set>
#include <sstream>

namespace penumbra
{
namespace
{
using Json = nlohmann::ordered_json;

// Of all rows, as not every renderer counts everything.
std::set<std::string> NamesOfCounts(const std::vector<SpeedRow>& rows)
{
  std::set<std::string> names;
  for (const SpeedRow& row : rows)
  {
    for (const auto& count : row.Counts)
    {
      names.insert(count.first);
    }
  }
  return names;
}

Json DescribeBounds(const std::vector<SpeedRow>& rows)
{
  Json bounds = Json::array();
  for (const SpeedBound& bound : JudgeSpeed(rows))
  {
    bounds.push_back({ { "name", bound.Name }, { "of", bound.Where }, { "value", bound.Value },
      { "limit", bound.Limit }, { "held", bound.IsHeld() } });
  }
  return bounds;
}

Json DescribeRun(const SpeedStudyResult& result, const std::string& command)
{
  return { { "penumbra", PENUMBRA_VERSION }, { "vtk", vtkVersion::GetVTKVersion() },
    { "openglRenderer", result.OpenGLRenderer }, { "machine", DescribeMachine() },
    { "command", command }, { "seeds", Json::array() } };
}

std::string Print(const Json& json)
{
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

// Nothing where there is none.
template <class T>
class Cell
{
public:
  explicit Cell(const std::optional<T>& value)
    : Value(value)
  {
  }
  friend std::ostream& operator<<(std::ostream& text, const Cell& cell)
  {
    return cell.Value ? text << *cell.Value : text;
  }

private:
  std::optional<T> Value;
};

std::optional<double> ErrorOf(const SpeedRow& row)
{
  return row.Error ? std::optional<double>(row.Error->RootMeanSquare) : std::nullopt;
}
}

//------------------------------------------------------------------------------
std::string WriteSpeedCsv(const SpeedStudyResult& result)
{
  const std::set<std::string> counts = NamesOfCounts(result.Rows);
  std::ostringstream text;
  text << "scene,edge,voxels,own_size,image,lights,variant,technique,resolution,cpu_seconds,"
          "seconds,relative,first_cpu_seconds,light_edit_cpu_seconds,opacity_edit_cpu_seconds,"
          "rmse,p99.9,changed_by_skipping,peak_memory_bytes";
  for (const std::string& name : counts)
  {
    text << "," << name;
  }
  text << "\n";
  for (const SpeedRow& row : result.Rows)
  {
    const auto p999 = row.Error ? std::optional<double>(row.Error->Percentile999) : std::nullopt;
    text << row.Scene << "," << row.Edge << "," << row.Voxels << "," << row.IsOwnSize << ","
         << row.Image << "," << row.Lights << ",\"" << row.Variant << "\"," << row.Technique << ","
         << row.Resolution << "," << row.CpuSeconds << "," << row.Seconds << "," << row.Relative
         << "," << row.First << "," << Cell(row.LightEdit) << "," << Cell(row.OpacityEdit) << ","
         << Cell(ErrorOf(row)) << "," << Cell(p999) << "," << Cell(row.ChangedBySkipping) << ","
         << Cell(row.PeakMemory);
    for (const std::string& name : counts)
    {
      const auto count = row.Counts.find(name);
      text << ","
           << Cell(count == row.Counts.end() ? std::nullopt : std::optional<double>(count->second));
    }
    text << "\n";
  }
  return text.str();
}

//------------------------------------------------------------------------------
std::string WriteSpeedJson(const SpeedStudyResult& result, const std::string& command)
{
  Json json = DescribeRun(result, command);
  json["bounds"] = DescribeBounds(result.Rows);
  json["notes"] = result.Notes;
  json["rows"] = nlohmann::json(result.Rows);
  return Print(json);
}

//------------------------------------------------------------------------------
std::string WriteSpeedCalibration(const SpeedStudyResult& result, const std::string& command)
{
  Json json = DescribeRun(result, command);
  json["measurements"] = Json::array();
  for (const SpeedRow& row : result.Rows)
  {
    if (row.Error && row.Technique != "none" && row.Lights == 1)
    {
      json["measurements"].push_back(
        { { "scene", row.Scene }, { "edge", row.Edge }, { "voxels", row.Voxels },
          { "image", row.Image }, { "variant", row.Variant }, { "technique", row.Technique },
          { "resolution", row.Resolution }, { "rmse", row.Error->RootMeanSquare },
          { "p999", row.Error->Percentile999 }, { "frame", row.Relative },
          { "lightEdit", row.InStockFrames(row.LightEdit.value_or(row.CpuSeconds)) },
          { "opacityEdit", row.InStockFrames(row.OpacityEdit.value_or(row.CpuSeconds)) },
          { "counts", row.Counts } });
    }
  }
  return Print(json);
}

}
