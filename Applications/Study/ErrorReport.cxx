#include "ErrorReport.h"

#include "ConvergenceOrder.h"
#include "NumberText.h"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <thread>

namespace penumbra
{
namespace
{
using Json = nlohmann::ordered_json;

constexpr double DefaultStep = 0.5;
constexpr double BoundAtDefaultStep = 1.0;
constexpr double BoundAtFinestStep = 0.5;
const char* const Rays = "penumbra rays";
const char* const Auto = "penumbra auto";

std::vector<ErrorRow> RowsOf(
  const std::vector<ErrorRow>& rows, const std::string& scene, const std::string& variant)
{
  std::vector<ErrorRow> found;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(found),
    [&](const ErrorRow& row) { return row.Scene == scene && row.Variant == variant; });
  return found;
}

std::string StepName(double step)
{
  return step >= 1.0 ? Fixed(step, 0) : "1/" + Fixed(1.0 / step, 0);
}

std::string OrderInWords(const std::vector<ErrorRow>& rows, const std::string& scene)
{
  const auto order = ObservedOrder(rows, scene, Rays);
  return order ? "order " + Fixed(*order, 1) : "too close to tell an order";
}

// A scene's errors over another member of their rows, a series for each variant. Points tell their
// step where the axis does not.
std::vector<ChartSeries> SeriesOf(
  const ErrorStudyResult& result, const std::string& scene, double ErrorRow::*place)
{
  std::vector<ChartSeries> all;
  for (const StudyVariant& variant : GetStudyVariants())
  {
    ChartSeries series;
    series.Name = variant.Name;
    for (const ErrorRow& row : RowsOf(result.Rows, scene, variant.Name))
    {
      series.X.push_back(row.*place);
      series.Y.push_back(row.Error.RootMeanSquare);
      if (place != &ErrorRow::Step)
      {
        series.Labels.push_back(StepName(row.Step));
      }
    }
    all.push_back(series);
  }
  return all;
}
}

//------------------------------------------------------------------------------
std::vector<std::string> ScenesOf(const ErrorStudyResult& result)
{
  std::vector<std::string> scenes;
  for (const ErrorRow& row : result.Rows)
  {
    if (scenes.empty() || scenes.back() != row.Scene)
    {
      scenes.push_back(row.Scene);
    }
  }
  return scenes;
}

//------------------------------------------------------------------------------
std::vector<ErrorRow> ParetoFront(const std::vector<ErrorRow>& rows, const std::string& scene)
{
  std::vector<ErrorRow> sorted;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(sorted),
    [&](const ErrorRow& row) { return row.Scene == scene; });
  std::sort(sorted.begin(), sorted.end(),
    [](const ErrorRow& a, const ErrorRow& b) { return a.CpuSeconds < b.CpuSeconds; });
  std::vector<ErrorRow> front;
  for (const ErrorRow& row : sorted)
  {
    if (front.empty() || row.Error.RootMeanSquare < front.back().Error.RootMeanSquare)
    {
      front.push_back(row);
    }
  }
  return front;
}

//------------------------------------------------------------------------------
std::string WriteErrorCsv(const ErrorStudyResult& result)
{
  std::ostringstream text;
  text << "scene,variant,step,rmse,mean,p99.9,largest,ssim,seconds,cpu_seconds,relative\n";
  text << std::setprecision(6);
  for (const ErrorRow& row : result.Rows)
  {
    text << row.Scene << "," << row.Variant << "," << row.Step << "," << row.Error.RootMeanSquare
         << "," << row.Error.Mean << "," << row.Error.Percentile999 << "," << row.Error.Largest
         << "," << row.Error.StructuralSimilarity << "," << row.Seconds << "," << row.CpuSeconds
         << "," << row.Relative << "\n";
  }
  return text.str();
}

//------------------------------------------------------------------------------
std::string WriteErrorJson(const ErrorStudyResult& result, const std::string& command)
{
  Json json = { { "penumbra", PENUMBRA_VERSION }, { "vtk", result.VTKVersion },
    { "openglRenderer", result.OpenGLRenderer },
    { "processors", std::thread::hardware_concurrency() }, { "command", command },
    { "seeds", Json::array() }, { "referenceError", result.ReferenceError },
    { "notes", result.Notes } };
  for (const ErrorRow& row : result.Rows)
  {
    json["rows"].push_back({ { "scene", row.Scene }, { "variant", row.Variant },
      { "step", row.Step }, { "rmse", row.Error.RootMeanSquare }, { "mean", row.Error.Mean },
      { "p999", row.Error.Percentile999 }, { "largest", row.Error.Largest },
      { "ssim", row.Error.StructuralSimilarity }, { "seconds", row.Seconds },
      { "cpuSeconds", row.CpuSeconds }, { "relative", row.Relative } });
  }
  return json.dump(1) + "\n";
}

//------------------------------------------------------------------------------
std::string WriteErrorMarkdown(const ErrorStudyResult& result)
{
  std::ostringstream text;
  text
    << R"(Errors are grey levels of 255 against the reference, times processor seconds of a frame,
and as multiples of VTK's unlit frame at steps of one voxel. Techniques that keep shadows have
them from the frame before. The order is the power of the step by which the error has fallen from
the step before. Rounding to 8 bits, taken for the error at the finest step (0.29 at most), is
subtracted from the squared errors first; an error of less than twice the rounding tells no order.
A scene's order is that of its finest steps that tell one, by rays.
)";
  for (const std::string& scene : ScenesOf(result))
  {
    text << "\n## " << scene << "\n"
         << OrderInWords(result.Rows, scene) << "\n\n"
         << "| | step | RMSE | order | mean | 99.9 % | largest | similarity | time | of unlit |\n"
         << "|---|---|---|---|---|---|---|---|---|---|\n";
    for (std::size_t at = 0; at < result.Rows.size(); ++at)
    {
      const ErrorRow& row = result.Rows[at];
      const auto order = OrderAt(result.Rows, at);
      if (row.Scene == scene)
      {
        text << "| " << row.Variant << " | " << StepName(row.Step) << " | "
             << Fixed(row.Error.RootMeanSquare, 2) << " | " << (order ? Fixed(*order, 1) : "-")
             << " | " << Fixed(row.Error.Mean, 2) << " | " << Fixed(row.Error.Percentile999, 1)
             << " | " << Fixed(row.Error.Largest, 1) << " | "
             << Fixed(row.Error.StructuralSimilarity, 4) << " | " << Fixed(row.CpuSeconds, 3)
             << " | " << Fixed(row.Relative, 2) << " |\n";
      }
    }
  }
  for (const std::string& note : result.Notes)
  {
    text << "\n" << note << "\n";
  }
  return text.str();
}

//------------------------------------------------------------------------------
ChartDescription ChartOfTime(const ErrorStudyResult& result, const std::string& scene)
{
  ChartDescription chart;
  chart.Title = scene + ": error over time";
  chart.XTitle = "processor time, in unlit frames of VTK";
  chart.YTitle = "RMSE, grey levels of 255";
  chart.Series = SeriesOf(result, scene, &ErrorRow::Relative);
  ChartLine front;
  front.Name = "Pareto front";
  for (const ErrorRow& row : ParetoFront(result.Rows, scene))
  {
    front.X.push_back(row.Relative);
    front.Y.push_back(row.Error.RootMeanSquare);
  }
  chart.Guides.push_back(front);
  return chart;
}

//------------------------------------------------------------------------------
ChartDescription ChartOfStep(const ErrorStudyResult& result, const std::string& scene)
{
  ChartDescription chart;
  chart.Title = scene + ": error over step, " + OrderInWords(result.Rows, scene);
  chart.XTitle = "step, voxels";
  chart.YTitle = "RMSE, grey levels of 255";
  chart.Series = SeriesOf(result, scene, &ErrorRow::Step);
  const auto rays = RowsOf(result.Rows, scene, Rays);
  if (rays.size() > 1)
  {
    const double coarsest = rays.front().Step;
    const double finest = rays.back().Step;
    const double error = rays.front().Error.RootMeanSquare;
    const double ratio = finest / coarsest;
    chart.Guides.push_back(
      { "second order", { coarsest, finest }, { error, error * ratio * ratio } });
  }
  return chart;
}

//------------------------------------------------------------------------------
ErrorSummary Summarize(const ErrorStudyResult& result)
{
  ErrorRow worst;
  double atFinest = 0.0;
  for (const ErrorRow& row : result.Rows)
  {
    const bool bounded = row.Variant == Rays || row.Variant == Auto;
    if (bounded && row.Step == DefaultStep &&
      row.Error.RootMeanSquare >= worst.Error.RootMeanSquare)
    {
      worst = row;
    }
  }
  for (const std::string& scene : ScenesOf(result))
  {
    const auto rays = RowsOf(result.Rows, scene, Rays);
    if (!rays.empty())
    {
      atFinest = std::max(atFinest, rays.back().Error.RootMeanSquare);
    }
  }
  const double atDefault = worst.Error.RootMeanSquare;
  ErrorSummary summary;
  summary.WithinBounds = atDefault <= BoundAtDefaultStep && atFinest <= BoundAtFinestStep;
  summary.Line = std::to_string(ScenesOf(result).size()) + " scenes, " +
    std::to_string(result.Rows.size()) + " pictures: RMSE at most " + Fixed(atDefault, 2) +
    " of 255 at the default step (" + worst.Scene + ", " + worst.Variant + "; bound " +
    Fixed(BoundAtDefaultStep, 1) + "), " + Fixed(atFinest, 2) + " at the finest by rays (bound " +
    Fixed(BoundAtFinestStep, 1) + ")";
  return summary;
}

}
