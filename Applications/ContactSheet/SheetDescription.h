/**
 * @file    SheetDescription.h
 * @brief   which pictures a contact sheet shows, and the words beside them
 *
 * In JSON, with the values that absent keys have:
 *
 *     { "title": "", "note": "",
 *       "columns": ["unlit", ...],
 *       "rows": [{ "title": "", "cells": [{ "picture": "a.png", "caption": "" }, ...] }, ...],
 *       "cellSize": [256, 256] }
 *
 * `columns`, `rows`, `cells` and `picture` are needed; each row has a cell for each column.
 * Relative paths are relative to the file. The first line of a caption stands out from those below
 * it.
 */

#ifndef SheetDescription_h
#define SheetDescription_h

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace penumbra
{

struct SheetCell
{
  std::filesystem::path Picture;
  std::string Caption;
};

struct SheetRow
{
  std::string Title;
  std::vector<SheetCell> Cells;
};

struct SheetDescription
{
  std::string Title;
  /// Below all rows.
  std::string Note;
  std::vector<std::string> Columns;
  std::vector<SheetRow> Rows;
  /// Width and height in which each picture is shown, in pixels.
  std::array<int, 2> CellSize{ 256, 256 };
};

/// @throw InputError where the file cannot be read or does not describe a sheet. The pictures are
/// not opened.
SheetDescription LoadSheet(const std::filesystem::path& file);

}

#endif
