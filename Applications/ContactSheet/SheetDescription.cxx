#include "SheetDescription.h"

#include "InputError.h"
#include "JsonObject.h"
#include "SceneFile.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace penumbra
{
namespace
{
namespace fs = std::filesystem;

constexpr std::size_t LongestText = 300;
constexpr std::size_t MostColumns = 50;
constexpr std::size_t MostRows = 200;
constexpr int SmallestCell = 32;
constexpr int LargestCell = 4096;

std::string ReadText(const fs::path& file)
{
  std::error_code error;
  std::ifstream stream(file, std::ios::binary);
  if (!stream || fs::is_directory(file, error))
  {
    throw InputError("it cannot be read; accepted: a JSON file");
  }
  return { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
}

// VTK's own fonts have no other letters, and leave out silently what they do not have.
bool IsInTypeface(char letter)
{
  return (letter >= ' ' && letter <= '~') || letter == '\n';
}

void RefuseUnfitText(const std::string& path, const std::string& text)
{
  if (text.size() > LongestText || !std::all_of(text.begin(), text.end(), IsInTypeface))
  {
    RefuseValue(path, text,
      "a string of at most " + std::to_string(LongestText) +
        " letters, printable ASCII and line breaks");
  }
}

void ReadLabel(JsonObject& object, const std::string& key, std::string& text)
{
  object.Read(key, text);
  RefuseUnfitText(object.PathOf(key), text);
}

void Require(JsonObject& object, const std::string& key)
{
  if (!object.Find(key))
  {
    throw InputError(object.PathOf(key) + " is missing");
  }
}

std::vector<std::pair<const nlohmann::json*, std::string>> ReadList(
  JsonObject& object, const std::string& key, std::size_t most)
{
  Require(object, key);
  auto entries = object.ReadArray(key);
  if (entries.empty() || entries.size() > most)
  {
    throw InputError(object.PathOf(key) + " has " + std::to_string(entries.size()) +
      " entries; accepted: from 1 to " + std::to_string(most));
  }
  return entries;
}

SheetCell ParseCell(const nlohmann::json& value, const std::string& path, const fs::path& folder)
{
  JsonObject object(value, path);
  SheetCell cell;
  std::string picture;
  Require(object, "picture");
  object.Read("picture", picture);
  ReadLabel(object, "caption", cell.Caption);
  object.RefuseUnknownKeys();
  cell.Picture = folder / fs::u8path(picture);
  return cell;
}

SheetRow ParseRow(const nlohmann::json& value, const std::string& path, const fs::path& folder,
  std::size_t numberOfColumns)
{
  JsonObject object(value, path);
  SheetRow row;
  ReadLabel(object, "title", row.Title);
  Require(object, "cells");
  for (const auto& [cell, cellPath] : object.ReadArray("cells"))
  {
    row.Cells.push_back(ParseCell(*cell, cellPath, folder));
  }
  object.RefuseUnknownKeys();
  if (row.Cells.size() != numberOfColumns)
  {
    throw InputError(path + ".cells has " + std::to_string(row.Cells.size()) +
      " entries; accepted: as many as there are columns, " + std::to_string(numberOfColumns));
  }
  return row;
}

SheetDescription ParseSheet(const nlohmann::json& value, const fs::path& folder)
{
  if (!value.is_object())
  {
    RefuseValue("the sheet", value, "an object, { ... }");
  }
  JsonObject object(value, "");
  SheetDescription sheet;
  ReadLabel(object, "title", sheet.Title);
  ReadLabel(object, "note", sheet.Note);
  for (const auto& [column, path] : ReadList(object, "columns", MostColumns))
  {
    if (!column->is_string())
    {
      RefuseValue(path, *column, "a string");
    }
    sheet.Columns.push_back(column->get<std::string>());
    RefuseUnfitText(path, sheet.Columns.back());
  }
  for (const auto& [row, path] : ReadList(object, "rows", MostRows))
  {
    sheet.Rows.push_back(ParseRow(*row, path, folder, sheet.Columns.size()));
  }
  object.Read("cellSize", sheet.CellSize, SmallestCell, LargestCell);
  object.RefuseUnknownKeys();
  return sheet;
}
}

//------------------------------------------------------------------------------
SheetDescription LoadSheet(const std::filesystem::path& file)
{
  try
  {
    return ParseSheet(ParseJson(ReadText(file)), fs::absolute(file).parent_path());
  }
  catch (const InputError& error)
  {
    throw InputError(file.u8string() + ": " + error.what());
  }
}

}
