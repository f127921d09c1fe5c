#include "Catch.h"
#include "SheetLayout.h"
#include "SheetOfColors.h"

using namespace penumbra;

using Json = nlohmann::json;

TEST_CASE("Pictures of a cell's size stand in a grid, pixel by pixel")
{
  const SheetOfColors folder;
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
  SheetOfColors folder;
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
  const SheetOfColors folder;
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
  SheetOfColors folder;
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

TEST_CASE("Columns grow with their widest text, all alike")
{
  SheetOfColors folder;
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
  const SheetOfColors folder;
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
