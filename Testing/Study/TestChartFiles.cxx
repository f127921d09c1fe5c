#include "Catch.h"
#include "ChartFiles.h"
#include "ImageComparison.h"

#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

using namespace penumbra;

TEST_CASE("A chart is a picture and a drawing of the size that was asked for")
{
  const TemporaryFolder folder;
  ChartDescription chart = MakeChart();
  chart.Width = 640;
  chart.Height = 400;
  WriteChart(chart, folder.PathOf("error-1.5"));
  CHECK(folder.Names() == std::vector<std::string>{ "error-1.5.png", "error-1.5.svg" });
  const auto picture = ReadPNG(folder.PathOf("error-1.5.png"));
  CHECK(picture->GetDimensions()[0] == 640);
  CHECK(picture->GetDimensions()[1] == 400);
  const auto drawing = vtkSmartPointer<vtkXMLDataElement>::Take(
    vtkXMLUtilities::ReadElementFromFile(folder.PathOf("error-1.5.svg").c_str()));
  REQUIRE(drawing);
  CHECK(drawing->GetAttribute("width") == std::string("640"));
  CHECK(drawing->GetAttribute("height") == std::string("400"));
  CHECK(drawing->GetAttribute("viewBox") == std::string("0 0 2560 1600"));
}

TEST_CASE("The same chart gives the same bytes, whatever was drawn before")
{
  const ChartFiles first = BytesOf(MakeChart());
  ChartDescription manyStyles = MakeChart();
  for (int i = 0; i < 12; ++i)
  {
    manyStyles.Series.push_back({ "n", { 1.0 + i }, { 2.0 }, { "label" } });
  }
  for (const int width : { 700, 1100, 1500 })
  {
    manyStyles.Width = width;
    manyStyles.Height = width;
    BytesOf(manyStyles);
  }
  const ChartFiles second = BytesOf(MakeChart());
  CHECK((first.Png == second.Png));
  CHECK((first.Svg == second.Svg));
}

TEST_CASE("The drawing is XML and has the titles and all names")
{
  const std::string svg = BytesOf(MakeChart()).Svg;
  const auto drawing =
    vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromString(svg.c_str()));
  REQUIRE(drawing);
  CHECK(drawing->GetName() == std::string("svg"));
  const auto textOf = [&drawing](const char* name)
  {
    vtkXMLDataElement* element = drawing->FindNestedElementWithName(name);
    return std::string(element ? element->GetCharacterData() : "");
  };
  CHECK_THAT(textOf("title"),
    Catch::Matchers::ContainsSubstring("Error over time\nof a <scene> & \"another\""));
  for (const char* name : { "RMSE over time", "rays", "maps", "Pareto <front>" })
  {
    CHECK_THAT(textOf("desc"), Catch::Matchers::ContainsSubstring(name));
  }
}

TEST_CASE("A chart that cannot be written leaves nothing, and what was there")
{
  const TemporaryFolder folder;
  folder.Write("file", "");
  folder.Write("taken.svg/inside", "");
  folder.Write("old.png", "old picture");
  folder.Write("old.svg", "old drawing");
  const auto names = folder.Names();
  const auto errorOf = [&folder](const std::string& name, const ChartDescription& chart)
  {
    try
    {
      WriteChart(chart, folder.PathOf(name));
    }
    catch (const std::runtime_error& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK_THAT(errorOf("missing/chart", MakeChart()),
    Catch::Matchers::ContainsSubstring("missing/chart.png") &&
      Catch::Matchers::ContainsSubstring("no folder"));
  CHECK_THAT(
    errorOf("file/chart", MakeChart()), Catch::Matchers::ContainsSubstring("file/chart.png"));
  CHECK_THAT(errorOf("taken", MakeChart()),
    Catch::Matchers::ContainsSubstring("taken.svg, which is a folder"));
  ChartDescription small = MakeChart();
  small.Width = 299;
  CHECK_THAT(errorOf("old", small),
    Catch::Matchers::ContainsSubstring("old: a chart of 299 x 600 pixels; accepted: from 300"));
  CHECK(folder.Names() == names);
  CHECK(ReadBytes(folder.PathOf("old.png")) == "old picture");
  CHECK(ReadBytes(folder.PathOf("old.svg")) == "old drawing");
}
