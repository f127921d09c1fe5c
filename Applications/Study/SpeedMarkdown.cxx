#include "SpeedMarkdown.h"

#include "NumberText.h"
#include "SpeedBounds.h"

#include <algorithm>
#include <set>

namespace penumbra
{
namespace
{
using Rows = std::vector<SpeedRow>;
using Words = std::vector<std::string>;

const char* const Head =
  "Times are processor seconds of all threads, medians of three, taken in turn with all others of\n"
  "their scene; \"of unlit\" is in unlit frames of VTK's own mapper of the same scene and sizes.\n"
  "Where bounds hold, auto's frames of four lights and of one beside them are medians of nine.\n"
  "Steps are one voxel, on view rays and on shadow rays. RMSE and 99.9 % are grey levels of 255\n"
  "against rays with half the shadow step, of \"unlit, 1/4 voxel\" against VTK's picture. "
  "\"Skipping\"\n"
  "is how many of 10,000 pixels it changes by more than a grey level. Memory is the peak of a\n"
  "process that draws 16 x 16 pixels, by auto all of them. Samples are those of view rays, shaded\n"
  "ones those whose light was computed; shadow steps are of rays from there, not of what is kept\n"
  "of shadows.\n";

struct ThesisCase
{
  const char* Scene;
  /// Unlit, lit, and with shadow rays.
  const char* Told;
};

const ThesisCase ThesisCases[] = { { "ct", "1, 1.08, 2.1" }, { "skull", "1, 1, 2.6" },
  { "bonsai", "-" }, { "engine", "-" } };

std::string Line(const Words& words)
{
  std::string line = "|";
  for (const std::string& word : words)
  {
    line += " " + word + " |";
  }
  return line + "\n";
}

// Nothing where there are no lines.
std::string Table(const std::string& title, const Words& columns, const std::vector<Words>& lines)
{
  if (lines.empty())
  {
    return "";
  }
  std::string text = "\n## " + title + "\n\n" + Line(columns) + "|";
  for (std::size_t column = 0; column < columns.size(); ++column)
  {
    text += "---|";
  }
  text += "\n";
  for (const Words& line : lines)
  {
    text += Line(line);
  }
  return text;
}

Rows PlainRows(const Rows& rows, const std::string& scene)
{
  Rows plain;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(plain),
    [&](const SpeedRow& row) { return row.Scene == scene && row.IsPlain(); });
  return plain;
}

const SpeedRow* Find(const Rows& rows, const std::string& variant)
{
  const auto found = std::find_if(
    rows.begin(), rows.end(), [&](const SpeedRow& row) { return row.Variant == variant; });
  return found == rows.end() ? nullptr : &*found;
}

std::string BoundTable(const Rows& rows)
{
  std::vector<Words> lines;
  for (const SpeedBound& bound : JudgeSpeed(rows))
  {
    lines.push_back({ bound.Name, Fixed(bound.Value, 2), Fixed(bound.Limit, 1), bound.Where,
      bound.IsHeld() ? "held" : "**missed**" });
  }
  return Table("Bounds", { "", "measured", "at most", "of", "" }, lines);
}

// Nothing is told where the stock mapper draws nothing.
std::string StockFrames(const SpeedRow& row, const std::optional<double>& seconds)
{
  return seconds && row.Relative > 0.0 ? Fixed(row.InStockFrames(*seconds), 2) : "-";
}

// In the scene's own unlit frames, and in VTK's.
std::string ThesisCell(const Rows& rows, const std::string& variant)
{
  const SpeedRow* unlit = Find(rows, "unlit");
  const SpeedRow* row = Find(rows, variant);
  return unlit && row && unlit->CpuSeconds > 0.0 ? Fixed(row->CpuSeconds / unlit->CpuSeconds, 2) +
      " (" + StockFrames(*row, row->CpuSeconds) + ")"
                                                 : "-";
}

std::string ThesisTable(const Rows& all)
{
  std::vector<Words> lines;
  for (const ThesisCase& thesis : ThesisCases)
  {
    const Rows rows = PlainRows(all, thesis.Scene);
    if (!rows.empty())
    {
      lines.push_back({ thesis.Scene, ThesisCell(rows, "unlit"), ThesisCell(rows, "lit"),
        ThesisCell(rows, "rays"), ThesisCell(rows, "rays, hard"), ThesisCell(rows, "auto"),
        thesis.Told });
    }
  }
  return Table("The thesis' test cases, in own unlit frames (in VTK's)",
    { "", "unlit", "lit", "soft shadow, rays", "hard shadow, rays", "soft shadow, auto",
      "thesis: unlit, lit, shadow rays" },
    lines);
}

std::set<std::string> NamesOfCounts(const Rows& rows)
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

// With the technique that drew it, where that is another.
std::string NameOf(const SpeedRow& row)
{
  const bool tellsItself =
    row.Technique.empty() || row.Technique == "none" || row.Variant.rfind(row.Technique, 0) == 0;
  return row.Variant + (tellsItself ? "" : " (" + row.Technique + ")");
}

Words SceneLine(const SpeedRow& row, const std::set<std::string>& counts)
{
  Words words = { NameOf(row), StockFrames(row, row.CpuSeconds), Fixed(row.CpuSeconds, 3),
    StockFrames(row, row.First), StockFrames(row, row.LightEdit), StockFrames(row, row.OpacityEdit),
    row.Error ? Fixed(row.Error->RootMeanSquare, 2) : "-",
    row.Error ? Fixed(row.Error->Percentile999, 1) : "-",
    row.ChangedBySkipping ? Fixed(1e4 * *row.ChangedBySkipping, 1) : "-",
    row.PeakMemory ? Fixed(1e-6 * static_cast<double>(*row.PeakMemory), 0) : "-" };
  for (const std::string& name : counts)
  {
    const auto count = row.Counts.find(name);
    words.push_back(count == row.Counts.end() ? "-" : Fixed(count->second, 0));
  }
  return words;
}

std::string SceneTable(const Rows& all, const std::string& scene)
{
  const Rows rows = PlainRows(all, scene);
  const std::set<std::string> counts = NamesOfCounts(rows);
  Words columns = { "", "of unlit", "time", "first frame", "moved light", "changed opacity", "RMSE",
    "99.9 %", "skipping", "MB" };
  columns.insert(columns.end(), counts.begin(), counts.end());
  std::vector<Words> lines;
  for (const SpeedRow& row : rows)
  {
    lines.push_back(SceneLine(row, counts));
  }
  return rows.empty()
    ? ""
    : Table(scene + ", " + std::to_string(rows.front().Edge) + " voxels along the longest edge",
        columns, lines);
}

// In the order in which they first come.
template <class Name>
Words NamesOf(const Rows& rows, const Name& nameOf)
{
  Words names;
  for (const SpeedRow& row : rows)
  {
    const std::string name = nameOf(row);
    if (std::find(names.begin(), names.end(), name) == names.end())
    {
      names.push_back(name);
    }
  }
  return names;
}

Words CellOf(const SpeedRow& row)
{
  return { row.Scene, std::to_string(row.Edge) + (row.IsOwnSize ? "" : ", resampled"),
    std::to_string(row.Image), std::to_string(row.Lights) };
}

// Sizes and lights, a line each, and the variants across.
std::string GridTable(const Rows& rows)
{
  const Words variants = NamesOf(rows, [](const SpeedRow& row) { return row.Variant; });
  Words columns = { "scene", "edge", "image", "lights" };
  columns.insert(columns.end(), variants.begin(), variants.end());
  std::vector<Words> lines;
  for (const std::string& cell :
    NamesOf(rows, [](const SpeedRow& row) { return Line(CellOf(row)); }))
  {
    Rows here;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(here),
      [&](const SpeedRow& row) { return Line(CellOf(row)) == cell; });
    Words line = CellOf(here.front());
    for (const std::string& variant : variants)
    {
      const SpeedRow* row = Find(here, variant);
      line.push_back(!row ? "-"
                          : (variant == StockUnlit ? Fixed(row->CpuSeconds, 3) + " s"
                                                   : StockFrames(*row, row->CpuSeconds)));
    }
    lines.push_back(line);
  }
  return Table("Sizes and lights, of unlit", columns, lines);
}
}

//------------------------------------------------------------------------------
std::string WriteSpeedMarkdown(const SpeedStudyResult& result)
{
  const Rows& rows = result.Rows;
  std::string text = Head + BoundTable(rows) + ThesisTable(rows);
  for (const std::string& scene : NamesOf(rows, [](const SpeedRow& row) { return row.Scene; }))
  {
    text += SceneTable(rows, scene);
  }
  text += GridTable(rows);
  for (const std::string& note : result.Notes)
  {
    text += "\n" + note + "\n";
  }
  return text;
}

}
