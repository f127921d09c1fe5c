#include "SheetLayout.h"

#include "InputError.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
constexpr int LongestSide = 16384;

constexpr std::array<double, 3> Ink{ 0.13, 0.14, 0.16 };
constexpr std::array<double, 3> QuietInk{ 0.42, 0.44, 0.47 };

using Lines = std::vector<TextLine>;

// All sizes follow that of the type, which follows that of the cells, so that a sheet looks the
// same at every size.
struct Measures
{
  explicit Measures(const std::array<int, 2>& cellSize)
    : Type(std::clamp(cellSize[0] * 11 / 200, 11, 96))
    , Head{ this->Times(1.6), true, Ink }
    , Label{ this->Type, true, Ink }
    , Detail{ this->Times(0.88), false, QuietInk }
    , Margin(this->Times(3.0))
    , Gutter(this->Times(1.25))
    , BetweenRows(this->Times(2.25))
    , BesideRowTitle(this->Times(1.75))
    , BelowHead(this->Times(1.75))
    , AboveNote(this->Times(2.25))
    , BesidePicture(this->Times(0.7))
  {
  }

  int Times(double factor) const { return static_cast<int>(std::lround(factor * this->Type)); }

  int Type;
  TypeStyle Head;
  TypeStyle Label;
  TypeStyle Detail;
  int Margin;
  int Gutter;
  int BetweenRows;
  int BesideRowTitle;
  int BelowHead;
  int AboveNote;
  int BesidePicture;
};

int HeightOf(const Lines& lines)
{
  int height = 0;
  for (const TextLine& line : lines)
  {
    height += LineHeight(line.Style);
  }
  return height;
}

int WidthOfAll(const Lines& lines)
{
  int width = 0;
  for (const TextLine& line : lines)
  {
    width = std::max(width, WidthOf(line));
  }
  return width;
}

class Composition
{
public:
  explicit Composition(const SheetDescription& sheet)
    : Sheet(sheet)
    , Sizes(sheet.CellSize)
    , ColumnWidth(sheet.CellSize[0])
  {
    for (const std::string& column : sheet.Columns)
    {
      this->ColumnTitleHeight = std::max(this->ColumnTitleHeight, this->Widen(column));
    }
    int rowTitleWidth = 0;
    for (const SheetRow& row : sheet.Rows)
    {
      for (const SheetCell& cell : row.Cells)
      {
        this->Widen(cell.Caption);
      }
      rowTitleWidth = std::max(rowTitleWidth, WidthOfAll(this->Labels(row.Title)));
    }
    this->FirstColumn =
      this->Sizes.Margin + (rowTitleWidth > 0 ? rowTitleWidth + this->Sizes.BesideRowTitle : 0);
  }

  SheetLayout Compose()
  {
    this->Top = this->Sizes.Margin;
    this->Write(SplitLines(this->Sheet.Title, this->Sizes.Head, this->Sizes.Detail),
      this->Sizes.Margin, this->Sizes.BelowHead);
    this->WriteColumnTitles();
    for (const SheetRow& row : this->Sheet.Rows)
    {
      this->WriteRow(row);
    }
    this->Top -= this->Sizes.BetweenRows;
    if (!this->Sheet.Note.empty())
    {
      this->Top += this->Sizes.AboveNote;
      this->Write(SplitLines(this->Sheet.Note, this->Sizes.Detail, this->Sizes.Detail),
        this->Sizes.Margin, 0);
    }
    const int columns = static_cast<int>(this->Sheet.Columns.size());
    this->WidthOfTexts = std::max(this->WidthOfTexts, this->Left(columns) - this->Sizes.Gutter);
    this->Layout.Size = { this->WidthOfTexts + this->Sizes.Margin, this->Top + this->Sizes.Margin };
    return std::move(this->Layout);
  }

private:
  Lines Labels(const std::string& text) const
  {
    return SplitLines(text, this->Sizes.Label, this->Sizes.Detail);
  }

  // Makes room for a text in every column, and tells its height.
  int Widen(const std::string& text)
  {
    const Lines lines = this->Labels(text);
    this->ColumnWidth = std::max(this->ColumnWidth, WidthOfAll(lines));
    return HeightOf(lines);
  }

  int Left(int column) const
  {
    return this->FirstColumn + column * (this->ColumnWidth + this->Sizes.Gutter);
  }

  void Place(const Lines& lines, SheetPlace place)
  {
    for (const TextLine& line : lines)
    {
      this->WidthOfTexts = std::max(this->WidthOfTexts, place.Left + WidthOf(line));
      this->Layout.Texts.push_back({ line, place });
      place.Top += LineHeight(line.Style);
    }
  }

  // The next of what stands one below the other.
  void Write(const Lines& lines, int left, int distanceBelow)
  {
    this->Place(lines, { left, this->Top });
    this->Top += lines.empty() ? 0 : HeightOf(lines) + distanceBelow;
  }

  void WriteColumnTitles()
  {
    for (std::size_t column = 0; column < this->Sheet.Columns.size(); ++column)
    {
      const Lines lines = this->Labels(this->Sheet.Columns[column]);
      this->Place(lines,
        { this->Left(static_cast<int>(column)),
          this->Top + this->ColumnTitleHeight - HeightOf(lines) });
    }
    this->Top +=
      this->ColumnTitleHeight > 0 ? this->ColumnTitleHeight + this->Sizes.BesidePicture : 0;
  }

  void WriteRow(const SheetRow& row)
  {
    const Lines title = this->Labels(row.Title);
    this->Place(title, { this->Sizes.Margin, this->Top });
    const int captionTop = this->Top + this->Sheet.CellSize[1] + this->Sizes.BesidePicture;
    int captionHeight = 0;
    for (std::size_t column = 0; column < row.Cells.size(); ++column)
    {
      const int left = this->Left(static_cast<int>(column));
      const Lines caption = this->Labels(row.Cells[column].Caption);
      this->Layout.Cells.push_back({ row.Cells[column].Picture, { left, this->Top } });
      this->Place(caption, { left, captionTop });
      captionHeight = std::max(captionHeight, HeightOf(caption));
    }
    const int belowPictures =
      captionHeight > 0 ? captionTop + captionHeight : this->Top + this->Sheet.CellSize[1];
    this->Top = std::max(belowPictures, this->Top + HeightOf(title)) + this->Sizes.BetweenRows;
  }

  const SheetDescription& Sheet;
  Measures Sizes;
  int ColumnWidth;
  int ColumnTitleHeight = 0;
  int FirstColumn = 0;
  int Top = 0;
  int WidthOfTexts = 0;
  SheetLayout Layout;
};
}

//------------------------------------------------------------------------------
SheetLayout LayOut(const SheetDescription& sheet)
{
  SheetLayout layout = Composition(sheet).Compose();
  if (layout.Size[0] > LongestSide || layout.Size[1] > LongestSide)
  {
    throw InputError("the sheet would have " + std::to_string(layout.Size[0]) + " x " +
      std::to_string(layout.Size[1]) + " pixels; accepted: at most " + std::to_string(LongestSide) +
      " each way (fewer pictures, or a smaller cellSize)");
  }
  return layout;
}

}
