#include "Catch.h"
#include "ImageComparison.h"
#include "RunProgram.h"

#include "SheetDescription.h"
#include "SheetLayout.h"
#include "SheetPicture.h"

#include <nlohmann/json.hpp>

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <functional>

using namespace penumbra;

namespace
{
using Json = nlohmann::json;
using Color = std::array<int, 3>;

constexpr Color Red{ 200, 30, 20 };
constexpr Color Green{ 20, 170, 40 };
constexpr Color Blue{ 30, 40, 210 };
constexpr Color Violet{ 140, 20, 160 };

vtkSmartPointer<vtkImageData> MakeUniform(
  int width, int height, const Color& color, int components = 3)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  for (int channel = 0; channel < components; ++channel)
  {
    image->GetPointData()->GetScalars()->FillComponent(channel, channel < 3 ? color[channel] : 0);
  }
  return image;
}

// Rows count from the top, as on a page.
Color ColorAt(vtkImageData* image, int x, int row)
{
  const int y = image->GetDimensions()[1] - 1 - row;
  const auto* levels = static_cast<const unsigned char*>(image->GetScalarPointer(x, y, 0));
  return { levels[0], levels[1], levels[2] };
}

struct Box
{
  int left = 1 << 20;
  int top = 1 << 20;
  int right = -1;
  int bottom = -1;
  int count = 0;

  int Width() const { return this->right - this->left + 1; }
  int Height() const { return this->bottom - this->top + 1; }
};

// The box of the pixels that are meant, among those within bounds.
Box FindBox(vtkImageData* image, const std::function<bool(const Color&)>& isMeant,
  const Box* within = nullptr)
{
  const int* size = image->GetDimensions();
  Box box;
  for (int row = within ? within->top : 0; row <= (within ? within->bottom : size[1] - 1); ++row)
  {
    for (int x = within ? within->left : 0; x <= (within ? within->right : size[0] - 1); ++x)
    {
      if (isMeant(ColorAt(image, x, row)))
      {
        box.left = std::min(box.left, x);
        box.right = std::max(box.right, x);
        box.top = std::min(box.top, row);
        box.bottom = std::max(box.bottom, row);
        ++box.count;
      }
    }
  }
  return box;
}

Box FindColor(vtkImageData* image, const Color& color)
{
  return FindBox(image, [&color](const Color& other) { return other == color; });
}

// What is darker than paper and no colour of a picture.
Box FindInk(vtkImageData* image, const Box& within)
{
  return FindBox(
    image,
    [](const Color& color)
    {
      const auto [least, most] = std::minmax_element(color.begin(), color.end());
      return *most < 200 && *most - *least < 30;
    },
    &within);
}

// Two rows of two pictures, each of one colour.
struct FourPictures : TemporaryFolder
{
  FourPictures()
  {
    WritePNG(MakeUniform(100, 80, Red), this->PathOf("red.png"));
    WritePNG(MakeUniform(100, 80, Green), this->PathOf("green.png"));
    WritePNG(MakeUniform(100, 80, Blue), this->PathOf("blue.png"));
    WritePNG(MakeUniform(100, 80, Violet), this->PathOf("violet.png"));
    this->Sheet = Json::parse(R"({ "columns": ["One", "Two"], "cellSize": [100, 80], "rows": [
      { "title": "Upper", "cells": [{ "picture": "red.png", "caption": "1 x" },
                                    { "picture": "green.png", "caption": "2 x\n0.3 s" }] },
      { "title": "Lower", "cells": [{ "picture": "blue.png", "caption": "3 x" },
                                    { "picture": "violet.png", "caption": "4 x" }] }] })");
  }

  vtkSmartPointer<vtkImageData> Make() const
  {
    const auto result = this->Run();
    INFO(result.error);
    REQUIRE(result.exitStatus == 0);
    CHECK(result.error.empty());
    return ReadPNG(this->PathOf("sheet.png"));
  }

  ProgramResult Run() const
  {
    this->Write("sheet.json", this->Sheet.dump());
    return RunProgram({ PENUMBRA_CONTACT_SHEET, this->PathOf("sheet.json"), "--output",
      this->PathOf("sheet.png") });
  }

  Json Sheet;
};
}

TEST_CASE("Pictures of a cell's size stand in a grid, pixel by pixel")
{
  const FourPictures folder;
  const auto sheet = folder.Make();
  REQUIRE(sheet->GetNumberOfScalarComponents() == 3);
  const Box red = FindColor(sheet, Red);
  const Box green = FindColor(sheet, Green);
  const Box blue = FindColor(sheet, Blue);
  const Box violet = FindColor(sheet, Violet);
  for (const Box& box : { red, green, blue, violet })
  {
    CHECK(box.Width() == 100);
    CHECK(box.Height() == 80);
    CHECK(box.count == 100 * 80);
  }
  CHECK(red.left == blue.left);
  CHECK(green.left == violet.left);
  CHECK(red.top == green.top);
  CHECK(blue.top == violet.top);
  CHECK(green.left > red.right);
  CHECK(blue.top > red.bottom);
}

TEST_CASE("The margins right and left are equal, and nothing is written on them")
{
  FourPictures folder;
  folder.Sheet["title"] = "Title";
  folder.Sheet["note"] = "A note";
  const auto sheet = folder.Make();
  const int* size = sheet->GetDimensions();
  const Color paper = ColorAt(sheet, 0, 0);
  const Box all = FindBox(sheet, [&paper](const Color& color) { return color != paper; });
  const Box violet = FindColor(sheet, Violet);
  const int margin = size[0] - 1 - violet.right;
  CHECK(margin >= 30);
  CHECK(all.right == violet.right);
  CHECK(std::abs(all.left - margin) <= 2); // letters begin a little beside their place
  CHECK(all.top >= margin);
  CHECK(size[1] - 1 - all.bottom >= margin);
}

TEST_CASE("Titles and captions leave ink where they belong, and nowhere else")
{
  const FourPictures folder;
  const auto sheet = folder.Make();
  const Box red = FindColor(sheet, Red);
  const Box green = FindColor(sheet, Green);
  const Box blue = FindColor(sheet, Blue);
  const auto inkBetween = [&](int left, int right, int top, int bottom)
  {
    Box within;
    within.left = left;
    within.right = right;
    within.top = top;
    within.bottom = bottom;
    return FindInk(sheet, within);
  };
  const int width = sheet->GetDimensions()[0];

  for (const Box& picture : { red, green })
  {
    const Box title = inkBetween(picture.left, picture.right, 0, picture.top - 1);
    CHECK(title.count > 20);
    CHECK(title.left - picture.left <= 3);
    CHECK(picture.top - title.bottom >= 4);
    const Box caption = inkBetween(picture.left, picture.right, picture.bottom + 1, blue.top - 1);
    CHECK(caption.count > 20);
    CHECK(caption.left - picture.left <= 3);
    CHECK(caption.top - picture.bottom >= 4);
    CHECK(blue.top - caption.bottom >= 10);
  }
  const auto rowTitle = inkBetween(0, red.left - 1, red.top, red.bottom);
  CHECK(rowTitle.count > 20);
  CHECK(rowTitle.top - red.top <= 4);
  CHECK(red.left - rowTitle.right >= 10);
  CHECK(inkBetween(red.right + 1, green.left - 1, red.top, red.bottom).count == 0);
  CHECK(inkBetween(green.right + 1, width - 1, 0, blue.bottom).count == 0);

  // The second line of a caption is below the first.
  const Box oneLine = inkBetween(red.left, red.right, red.bottom + 1, blue.top - 1);
  const Box twoLines = inkBetween(green.left, green.right, red.bottom + 1, blue.top - 1);
  CHECK(oneLine.top == twoLines.top);
  CHECK(twoLines.Height() > oneLine.Height() + 8);
}

TEST_CASE("A sheet without words has no room for them")
{
  FourPictures folder;
  folder.Sheet["columns"] = { "", "" };
  for (Json& row : folder.Sheet["rows"])
  {
    row.erase("title");
    for (Json& cell : row["cells"])
    {
      cell.erase("caption");
    }
  }
  const auto sheet = folder.Make();
  const Box red = FindColor(sheet, Red);
  const Box violet = FindColor(sheet, Violet);
  CHECK(red.left == red.top);
  CHECK(sheet->GetDimensions()[0] - 1 - violet.right == red.left);
  CHECK(sheet->GetDimensions()[1] - 1 - violet.bottom == red.top);
}

TEST_CASE("Larger pictures are scaled down into their cell, smaller ones stay in its middle")
{
  FourPictures folder;
  WritePNG(MakeUniform(400, 160, Green), folder.PathOf("green.png"));
  WritePNG(MakeUniform(40, 30, Blue), folder.PathOf("blue.png"));
  const auto sheet = folder.Make();
  const Box red = FindColor(sheet, Red);
  const Box green = FindColor(sheet, Green);
  const Box blue = FindColor(sheet, Blue);
  const Box violet = FindColor(sheet, Violet);
  CHECK(green.Width() == 100);
  CHECK(green.Height() == 40);
  CHECK(green.count == 100 * 40);
  CHECK(green.left == violet.left);
  CHECK(green.top == red.top + 20);
  CHECK(blue.Width() == 40);
  CHECK(blue.Height() == 30);
  CHECK(blue.left == red.left + 30);
  CHECK(blue.top == violet.top + 25);
}

TEST_CASE("A pixel of a picture that is scaled down is what its area was")
{
  const FourPictures folder;
  auto edged = MakeUniform(1000, 800, { 255, 255, 255 });
  for (int y = 0; y < 800; ++y)
  {
    auto* row = static_cast<unsigned char*>(edged->GetScalarPointer(0, y, 0));
    std::fill(row, row + 3 * 10, static_cast<unsigned char>(0));
  }
  WritePNG(edged, folder.PathOf("green.png"));
  const auto sheet = folder.Make();
  const int left = FindColor(sheet, Violet).left;
  const int middle = FindColor(sheet, Red).top + 40;
  CHECK(ColorAt(sheet, left, middle)[0] < 40);
  CHECK(ColorAt(sheet, left + 1, middle)[0] > 215);
  CHECK(ColorAt(sheet, left + 50, middle)[0] == 255);
}

TEST_CASE("A picture keeps its right, its left, its top and its bottom")
{
  const FourPictures folder;
  auto corners = MakeUniform(100, 80, Red);
  auto* upperLeft = static_cast<unsigned char*>(corners->GetScalarPointer(0, 79, 0));
  auto* lowerRight = static_cast<unsigned char*>(corners->GetScalarPointer(99, 0, 0));
  std::copy(Green.begin(), Green.end(), upperLeft);
  std::copy(Violet.begin(), Violet.end(), lowerRight);
  WritePNG(corners, folder.PathOf("blue.png"));
  WritePNG(MakeUniform(100, 80, Blue), folder.PathOf("green.png"));
  WritePNG(MakeUniform(100, 80, Blue), folder.PathOf("violet.png"));
  const auto sheet = folder.Make();
  const Box upper = FindColor(sheet, Green);
  const Box lower = FindColor(sheet, Violet);
  CHECK(upper.count == 1);
  CHECK(lower.count == 1);
  CHECK(lower.left - upper.left == 99);
  CHECK(lower.top - upper.top == 79);
}

TEST_CASE("Where a picture is transparent the cell is seen")
{
  const FourPictures folder;
  WritePNG(MakeUniform(100, 80, Green, 4), folder.PathOf("green.png"));
  const auto sheet = folder.Make();
  CHECK(FindColor(sheet, Green).count == 0);
  const Box red = FindColor(sheet, Red);
  const Box violet = FindColor(sheet, Violet);
  const Color seen = ColorAt(sheet, violet.left + 50, red.top + 40);
  CHECK(*std::min_element(seen.begin(), seen.end()) > 200);
}

TEST_CASE("Pictures of one channel, and of 16 bits, are shown as they are")
{
  const FourPictures folder;
  auto deep = vtkSmartPointer<vtkImageData>::New();
  deep->SetDimensions(100, 80, 1);
  deep->AllocateScalars(VTK_UNSIGNED_SHORT, 3);
  for (int channel = 0; channel < 3; ++channel)
  {
    deep->GetPointData()->GetScalars()->FillComponent(channel, Green[channel] * 257);
  }
  WritePNG(deep, folder.PathOf("green.png"));
  WritePNG(MakeUniform(100, 80, { 99, 0, 0 }, 1), folder.PathOf("blue.png"));
  const auto sheet = folder.Make();
  CHECK(FindColor(sheet, Green).count == 100 * 80);
  CHECK(FindColor(sheet, { 99, 99, 99 }).count >= 100 * 80);
}

TEST_CASE("Columns grow with their widest text, all alike")
{
  FourPictures folder;
  folder.Sheet["rows"][1]["cells"][0]["caption"] = "A caption that is wider than its picture";
  const auto sheet = folder.Make();
  const Box red = FindColor(sheet, Red);
  const Box green = FindColor(sheet, Green);
  const Box blue = FindColor(sheet, Blue);
  CHECK(red.Width() == 100);
  CHECK(green.left - red.left > 200);
  Box below;
  below.left = blue.left;
  below.right = sheet->GetDimensions()[0] - 1;
  below.top = blue.bottom + 1;
  below.bottom = sheet->GetDimensions()[1] - 1;
  Box ofFirst = below;
  ofFirst.right = green.left - 1;
  CHECK(FindInk(sheet, ofFirst).Width() > 200);
  CHECK(green.left - FindInk(sheet, ofFirst).right >= 8);
  CHECK(below.right - FindColor(sheet, Violet).right > 100);
}

TEST_CASE("The same sheet gives the same bytes")
{
  const FourPictures folder;
  folder.Make();
  const std::string first = ReadAll(folder.PathOf("sheet.png"));
  folder.Make();
  CHECK(ReadAll(folder.PathOf("sheet.png")) == first);
}

TEST_CASE("A layout grows with the size of its cells")
{
  SheetDescription sheet;
  sheet.Columns = { "One", "Two" };
  sheet.Rows = { { "Row", { { "a.png", "1 x" }, { "b.png", "2 x" } } } };
  sheet.CellSize = { 200, 200 };
  const SheetLayout small = LayOut(sheet);
  sheet.CellSize = { 400, 400 };
  const SheetLayout large = LayOut(sheet);
  REQUIRE(small.Cells.size() == 2);
  REQUIRE(small.Texts.size() == 5);
  CHECK(large.Size[0] == Approx(2.0 * small.Size[0]).epsilon(0.02));
  CHECK(large.Size[1] == Approx(2.0 * small.Size[1]).epsilon(0.02));
  for (std::size_t text = 0; text < small.Texts.size(); ++text)
  {
    CHECK(large.Texts[text].Line.Style.Size ==
      Approx(2.0 * small.Texts[text].Line.Style.Size).margin(1.0));
  }
}

TEST_CASE("What does not describe a sheet ends with status 2, one line, and nothing written")
{
  FourPictures folder;
  struct Fault
  {
    std::string pointer;
    Json value;
    std::string said;
  };
  folder.Write("text.png", "no picture");
  const std::string whole = ReadAll(folder.PathOf("red.png"));
  folder.Write("cut.png", whole.substr(0, whole.size() - 40));
  std::string torn = whole;
  torn[torn.size() / 2] ^= 1;
  folder.Write("torn.png", torn);
  const std::string picture = "/rows/1/cells/0/picture";
  const std::string caption = "/rows/1/cells/0/caption";
  const std::vector<Fault> faults = {
    { "/columns", { "One" }, "rows.0.cells has 2 entries; accepted: as many as there are columns" },
    { "/columns", Json::array(), "columns has 0 entries" },
    { "/columns/1", 7, "columns.1 is 7" },
    { "/rows", Json::array(), "rows has 0 entries" },
    { "/rows/1/cells", Json::array(), "rows.1.cells has 0 entries" },
    { "/rows/0", Json::object(), "rows.0.cells is missing" },
    { "/rows/1/cells/0", Json::object(), "rows.1.cells.0.picture is missing" },
    { "/rows/1/cells/0/capton", "4 x", "rows.1.cells.0.capton" },
    { "/heading", "Title", "heading is \"Title\": unknown key" },
    { caption, 3, "rows.1.cells.0.caption is 3" },
    { caption, "3 \xc3\x97", "printable ASCII" },
    { caption, std::string(301, 'a'), "at most 300 letters" },
    { "/cellSize", { 100 }, "cellSize" },
    { "/cellSize", { 100, 8 }, "cellSize" },
    { "/cellSize", { 4096, 16384 }, "cellSize" },
    { picture, "none.png", "none.png cannot be read; accepted: a PNG file" },
    { picture, "text.png", "text.png is no whole PNG file" },
    { picture, "..", "cannot be read" },
    { picture, "torn.png", "torn.png is no whole PNG file" },
    { picture, "cut.png", "cut.png is no whole PNG file" },
  };
  const Json sound = folder.Sheet;
  folder.Write("sheet.json", "");
  const auto before = folder.Names();
  for (const Fault& fault : faults)
  {
    folder.Sheet = sound;
    folder.Sheet[Json::json_pointer(fault.pointer)] = fault.value;
    const auto result = folder.Run();
    INFO(fault.said << ": " << result.error);
    CHECK(result.exitStatus == 2);
    CHECK(std::count(result.error.begin(), result.error.end(), '\n') == 1);
    CHECK_THAT(result.error, Catch::Matchers::ContainsSubstring(fault.said));
    CHECK(folder.Names() == before);
  }
}

TEST_CASE("A sheet that would be too large is refused")
{
  FourPictures folder;
  const Json row = folder.Sheet["rows"][0];
  folder.Sheet["cellSize"] = { 100, 4096 };
  for (int i = 0; i < 3; ++i)
  {
    folder.Sheet["rows"].push_back(row);
  }
  const auto result = folder.Run();
  CHECK(result.exitStatus == 2);
  CHECK_THAT(result.error, Catch::Matchers::ContainsSubstring("at most 16384 each way"));
}

TEST_CASE("Wrong use of the program ends with status 2 and one line")
{
  const FourPictures folder;
  const std::string sheet = folder.Write("sheet.json", folder.Sheet.dump());
  struct Use
  {
    std::vector<std::string> arguments;
    std::string said;
  };
  const std::vector<Use> uses = {
    { {}, "no sheet was named" },
    { { sheet }, "no --output was named" },
    { { sheet, "--bogus" }, "--bogus" },
    { { sheet, "--output", folder.PathOf("a.mha") }, "accepted: a name that ends in .png\n" },
    { { sheet, "--output", folder.PathOf("a.jpg") }, "accepted: a name that ends in .png\n" },
    { { sheet, "--output", folder.PathOf("none/a.png") }, "folder" },
    { { sheet, "--output", folder.PathOf("red.png") }, "cannot be written too" },
    { { folder.PathOf("none.json"), "--output", folder.PathOf("a.png") }, "none.json" },
    { { folder.PathOf("red.png"), "--output", folder.PathOf("a.png") }, "not valid JSON" },
  };
  const auto before = folder.Names();
  const std::string red = ReadAll(folder.PathOf("red.png"));
  for (const Use& use : uses)
  {
    std::vector<std::string> command = { PENUMBRA_CONTACT_SHEET };
    command.insert(command.end(), use.arguments.begin(), use.arguments.end());
    const auto result = RunProgram(command);
    INFO(use.said << ": " << result.error);
    CHECK(result.exitStatus == 2);
    CHECK(std::count(result.error.begin(), result.error.end(), '\n') == 1);
    CHECK_THAT(result.error, Catch::Matchers::ContainsSubstring(use.said));
    CHECK(folder.Names() == before);
  }
  CHECK(ReadAll(folder.PathOf("red.png")) == red);
  CHECK(RunProgram({ PENUMBRA_CONTACT_SHEET, "--help" }).exitStatus == 0);
}
