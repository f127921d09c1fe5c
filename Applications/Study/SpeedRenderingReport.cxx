#include "SpeedRenderingReport.h"

#include <nlohmann/json.hpp>

#include <utility>

namespace penumbra
{
namespace
{
// What a report counts. Where there is none of it, it is left out or null.
std::map<std::string, double> CountsOf(const nlohmann::json& report)
{
  static const std::pair<const char*, const char*> places[] = { { "/emptySpace/bricks", "bricks" },
    { "/emptySpace/occupiedBricks", "occupied bricks" }, { "/keptShadows/bytes", "shadow bytes" },
    { "/keptShadows/nearSteps", "near steps" }, { "/gradientTexture/bytes", "gradient bytes" },
    { "/rayCounts/samples", "samples" }, { "/rayCounts/shadedSamples", "shaded samples" },
    { "/rayCounts/shadowSteps", "shadow steps" } };
  std::map<std::string, double> counts;
  for (const auto& [place, name] : places)
  {
    const nlohmann::json::json_pointer pointer(place);
    if (report.contains(pointer) && report[pointer].is_number())
    {
      counts[name] = report[pointer];
    }
  }
  return counts;
}
}

//------------------------------------------------------------------------------
void ReadReport(const nlohmann::json& report, SpeedRow& row)
{
  using Pointer = nlohmann::json::json_pointer;
  row.Technique = report["technique"];
  row.Resolution = report.value(Pointer("/keptShadows/resolution"), row.Resolution);
  row.Counts = CountsOf(report);
}

//------------------------------------------------------------------------------
bool SkipsEmptySpace(const nlohmann::json& report)
{
  return report["requirements"].value("empty-space skipping", "no") == "yes";
}

}
