#include "StudyChart.h"

#include "ChartLayout.h"
#include "ChartText.h"
#include "ChartWindow.h"
#include "OffscreenWindow.h"
#include "OutputFile.h"
#include "Picture.h"
#include "RenderingError.h"

#include <vtkImageData.h>
#include <vtkImageShrink3D.h>
#include <vtkNew.h>
#include <vtkSVGExporter.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <random>

namespace penumbra
{
namespace
{
namespace fs = std::filesystem;

constexpr int SmallestSide = 300;
constexpr int LargestSide = 2048;
// OpenGL draws lines and markers with hard edges: charts are drawn larger, and made smaller by
// averaging.
constexpr int Oversampling = 4;

void RefuseSize(const ChartDescription& chart)
{
  const auto [least, most] = std::minmax(chart.Width, chart.Height);
  if (least < SmallestSide || most > LargestSide)
  {
    throw RenderingError("a chart of " + std::to_string(chart.Width) + " x " +
      std::to_string(chart.Height) + " pixels; accepted: from " + std::to_string(SmallestSide) +
      " to " + std::to_string(LargestSide) + " each way");
  }
}

std::string DrawPng(const ChartWindow& window)
{
  vtkNew<vtkImageShrink3D> shrink;
  shrink->SetInputData(ReadPicture(window.Get()));
  shrink->SetShrinkFactors(Oversampling, Oversampling, 1);
  shrink->AveragingOn();
  shrink->Update();
  return EncodePicture(shrink->GetOutput(), PictureFormat::Png);
}

// A file that VTK writes and that is gone thereafter.
class PassingFile
{
public:
  explicit PassingFile(const fs::path& folder)
    : Path(folder / ("penumbra-" + std::to_string(std::random_device()()) + ".unfinished"))
  {
  }

  ~PassingFile()
  {
    std::error_code ignored;
    fs::remove(this->Path, ignored);
  }
  PassingFile(const PassingFile&) = delete;
  PassingFile& operator=(const PassingFile&) = delete;

  std::string GetName() const { return this->Path.u8string(); }

  std::string Read() const
  {
    std::ifstream stream(this->Path, std::ios::binary);
    return { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
  }

private:
  fs::path Path;
};

std::string NamesIn(const ChartDescription& chart)
{
  std::string names = chart.YTitle + " over " + chart.XTitle;
  for (const ChartSeries& series : chart.Series)
  {
    names += "\n" + series.Name;
  }
  for (const ChartLine& guide : chart.Guides)
  {
    names += "\n" + guide.Name;
  }
  return names;
}

std::string SizeAttributes(int width, int height)
{
  return "width=\"" + std::to_string(width) + "\" height=\"" + std::to_string(height) + "\"";
}

// VTK gives the size of its window, and nothing from which others could be had.
std::string MakeScalable(std::string drawing, const ChartDescription& chart)
{
  const int width = Oversampling * chart.Width;
  const int height = Oversampling * chart.Height;
  const std::string written = SizeAttributes(width, height);
  const auto place = drawing.find(written);
  const bool isWhole = drawing.find("</svg>") != std::string::npos;
  if (place == std::string::npos || !isWhole)
  {
    throw RenderingError("VTK could not write the drawing");
  }
  return drawing.replace(place, written.size(),
    SizeAttributes(chart.Width, chart.Height) + " viewBox=\"0 0 " + std::to_string(width) + " " +
      std::to_string(height) + "\"");
}

std::string DrawSvg(
  const ChartWindow& window, const ChartDescription& chart, const fs::path& folder)
{
  const PassingFile file(folder);
  vtkNew<vtkSVGExporter> exporter;
  exporter->SetRenderWindow(window.Get());
  exporter->SetTitle(InTypeface(chart.Title).c_str());
  exporter->SetDescription(InTypeface(NamesIn(chart)).c_str());
  exporter->SetFileName(file.GetName().c_str());
  exporter->Write();
  return MakeScalable(file.Read(), chart);
}

fs::path Extended(const fs::path& file, const char* extension)
{
  fs::path extended = file;
  return extended += extension;
}

void WriteBoth(const ChartDescription& chart, OutputFile& png, OutputFile& svg)
{
  RefuseSize(chart);
  UseOffscreenWindows();
  const ChartWindow window(LayOutChart(chart), Oversampling);
  png.Write(DrawPng(window));
  svg.Write(DrawSvg(window, chart, fs::absolute(svg.GetTarget()).parent_path()));
}
}

//------------------------------------------------------------------------------
void WriteChart(const ChartDescription& chart, const fs::path& fileWithoutExtension)
{
  OutputFile png("the chart", Extended(fileWithoutExtension, ".png"));
  OutputFile svg("the chart", Extended(fileWithoutExtension, ".svg"));
  try
  {
    WriteBoth(chart, png, svg);
  }
  catch (const std::runtime_error& error)
  {
    throw RenderingError(fileWithoutExtension.u8string() + ": " + error.what());
  }
  png.Commit();
  svg.Commit();
}

}
