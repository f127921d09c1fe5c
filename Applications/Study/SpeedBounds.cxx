#include "SpeedBounds.h"

#include "Median.h"
#include "NumberText.h"
#include "SpeedGrid.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

namespace penumbra
{
namespace
{
using Rows = std::vector<SpeedRow>;
using Value = std::function<std::optional<double>(const SpeedRow&)>;

constexpr double LargestError = 1.0;

// As it was asked for, or as auto chose it.
bool IsCached(const SpeedRow& row)
{
  static const std::set<std::string> cached = { "volume", "deep-map", "opacity-map" };
  return cached.count(row.Technique) > 0 && (row.Variant == row.Technique || row.Variant == "auto");
}

bool IsCachedOrAuto(const SpeedRow& row)
{
  return IsCached(row) || row.Variant == "auto";
}

Rows Select(const Rows& rows, const std::function<bool(const SpeedRow&)>& wanted)
{
  Rows selected;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(selected), wanted);
  return selected;
}

double Relative(const SpeedRow& row)
{
  return row.Relative;
}

std::string SceneCount(std::size_t count)
{
  return std::to_string(count) + (count == 1 ? " scene" : " scenes");
}

class Judgement
{
public:
  explicit Judgement(const Rows& rows)
    : All(rows)
    , Plain(Select(rows,
        [](const SpeedRow& row) { return row.HasBounds && row.IsPlain() && row.Relative > 0.0; }))
  {
  }

  std::vector<SpeedBound> Run()
  {
    this->AddMedian("unlit", 0.3, this->PlainRows("unlit"));
    this->AddMedian("lit", 0.4, this->PlainRows("lit"));
    const Rows cached = this->BestCached();
    this->AddMedian("a soft shadow from a cache", 0.4, cached);
    this->AddLargest("a soft shadow from a cache, on any", 0.6, cached, Relative);
    this->AddMedian("a soft shadow by rays", 1.2, this->PlainRows("rays"));
    this->AddLargest("four lights over one", 1.5, this->RowsOfFourLights(),
      [this](const SpeedRow& row) { return this->OverOneLight(row); });
    this->AddLargest("a moved light", 3.0, this->PlainRows("auto"),
      [](const SpeedRow& row) { return row.InStockFrames(row.LightEdit.value_or(0.0)); });
    this->AddLargest("a changed opacity", 3.0, this->PlainRows("auto"),
      [](const SpeedRow& row) { return row.InStockFrames(row.OpacityEdit.value_or(0.0)); });
    this->AddLargest("twice the edge", 2.2, this->OfEdge(128),
      [this](const SpeedRow& row) { return this->OverEdge(row, 256); });
    this->AddLargest("error of cached shadows", LargestError, Select(this->Plain, IsCachedOrAuto),
      [](const SpeedRow& row) { return row.Error->RootMeanSquare; });
    this->AddLargest("pixels changed by skipping, of 10000", 1.0, this->Plain,
      [](const SpeedRow& row) -> std::optional<double>
      {
        return row.ChangedBySkipping ? std::optional<double>(1e4 * *row.ChangedBySkipping)
                                     : std::nullopt;
      });
    this->AddLargest("unlit from the stock picture, at a quarter voxel", 1.0,
      this->PlainRows("unlit, 1/4 voxel"),
      [](const SpeedRow& row) { return row.Error->RootMeanSquare; });
    return this->Bounds;
  }

private:
  Rows PlainRows(const std::string& variant) const
  {
    return Select(this->Plain, [&](const SpeedRow& row) { return row.Variant == variant; });
  }

  // Of all scenes, as those with bounds may have one size only.
  Rows OfEdge(int edge) const
  {
    if (this->Plain.empty())
    {
      return {};
    }
    static const std::set<std::string> variants = { "unlit", "lit", "auto" };
    return Select(this->All,
      [edge](const SpeedRow& row)
      {
        return !row.IsOwnSize && row.Edge == edge && row.Lights == 1 && row.Image == 512 &&
          variants.count(row.Variant) > 0;
      });
  }

  Rows BestCached() const
  {
    std::map<std::string, SpeedRow> best;
    for (const SpeedRow& row : Select(this->Plain, IsCached))
    {
      const auto [known, isNew] = best.try_emplace(row.Scene, row);
      known->second = isNew || IsBetter(row, known->second) ? row : known->second;
    }
    Rows rows;
    std::transform(best.begin(), best.end(), std::back_inserter(rows),
      [](const auto& entry) { return entry.second; });
    return rows;
  }

  static bool IsBetter(const SpeedRow& row, const SpeedRow& other)
  {
    const double error = row.Error->RootMeanSquare;
    const double otherError = other.Error->RootMeanSquare;
    if (error <= LargestError && otherError <= LargestError)
    {
      return row.CpuSeconds < other.CpuSeconds;
    }
    return error < otherError;
  }

  Rows RowsOfFourLights() const
  {
    return Select(this->All,
      [](const SpeedRow& row)
      {
        return row.HasBounds && row.IsOwnSize && row.Image == 512 && row.Lights == 4 &&
          row.Variant == "auto";
      });
  }

  // Over the frame with one of the lights, which was timed in turn with it.
  std::optional<double> OverOneLight(const SpeedRow& row) const
  {
    return Divide(row,
      this->FindOf(row,
        [&](const SpeedRow& other) {
          return other.IsOwnSize && other.Lights == row.Lights && other.Variant == AutoOfOneLight;
        }));
  }

  // What a scene costs with so many voxels, over what it costs in this row.
  std::optional<double> OverEdge(const SpeedRow& row, int edge) const
  {
    const SpeedRow* larger = this->FindOf(row,
      [&](const SpeedRow& other)
      {
        return !other.IsOwnSize && other.Edge == edge && other.Lights == row.Lights &&
          other.Variant == row.Variant;
      });
    return larger ? Divide(*larger, &row) : std::nullopt;
  }

  // Another row of the scene at the same image size. Null where there is none.
  const SpeedRow* FindOf(
    const SpeedRow& row, const std::function<bool(const SpeedRow&)>& isMeant) const
  {
    const auto found = std::find_if(this->All.begin(), this->All.end(),
      [&](const SpeedRow& other)
      { return other.Scene == row.Scene && other.Image == row.Image && isMeant(other); });
    return found == this->All.end() ? nullptr : &*found;
  }

  static std::optional<double> Divide(const SpeedRow& row, const SpeedRow* by)
  {
    return by && by->CpuSeconds > 0.0 ? std::optional<double>(row.CpuSeconds / by->CpuSeconds)
                                      : std::nullopt;
  }

  void AddMedian(const std::string& name, double limit, const Rows& rows)
  {
    std::vector<double> values;
    std::transform(rows.begin(), rows.end(), std::back_inserter(values), Relative);
    if (!values.empty())
    {
      this->Bounds.push_back(
        { name, "median of " + SceneCount(values.size()), limit, Median(values) });
    }
  }

  void AddLargest(const std::string& name, double limit, const Rows& rows, const Value& value)
  {
    std::optional<SpeedBound> largest;
    for (const SpeedRow& row : rows)
    {
      const auto found = value(row);
      if (found && (!largest || *found > largest->Value))
      {
        largest = SpeedBound{ name, row.Scene + ", " + row.Variant, limit, *found };
      }
    }
    if (largest)
    {
      this->Bounds.push_back(*largest);
    }
  }

  const Rows& All;
  Rows Plain;
  std::vector<SpeedBound> Bounds;
};
}

//------------------------------------------------------------------------------
std::vector<SpeedBound> JudgeSpeed(const std::vector<SpeedRow>& rows)
{
  return Judgement(rows).Run();
}

//------------------------------------------------------------------------------
SpeedSummary SummarizeSpeed(const std::vector<SpeedRow>& rows)
{
  std::set<std::string> scenes;
  std::transform(rows.begin(), rows.end(), std::inserter(scenes, scenes.end()),
    [](const SpeedRow& row) { return row.Scene; });
  std::string held;
  std::string missed;
  for (const SpeedBound& bound : JudgeSpeed(rows))
  {
    const std::string words = bound.Name + " " + Fixed(bound.Value, 2) + " (" +
      (bound.IsHeld() ? "bound " : "more than ") + Fixed(bound.Limit, 1) + ")";
    std::string& list = bound.IsHeld() ? held : missed;
    list += (list.empty() ? "" : ", ") + words;
  }
  SpeedSummary summary;
  summary.WithinBounds = missed.empty();
  summary.Line = SceneCount(scenes.size()) + ", " + std::to_string(rows.size()) +
    " ways of drawing" + (held.empty() ? "" : "; held: " + held) +
    (missed.empty() ? "" : "; missed: " + missed);
  return summary;
}

}
