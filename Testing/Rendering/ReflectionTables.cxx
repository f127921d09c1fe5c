#include "ReflectionTables.h"

#include <cmath>
#include <fstream>
#include <sstream>

namespace
{
std::string Trimmed(const std::string& text)
{
  const size_t first = text.find_first_not_of(' ');
  const size_t last = text.find_last_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

std::vector<std::string> Split(const std::string& text, char separator)
{
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);)
  {
    parts.push_back(Trimmed(part));
  }
  return parts;
}

// Of "| a | b |"; none where the line is no row of a table.
std::vector<std::string> Cells(const std::string& line)
{
  const std::string row = Trimmed(line);
  if (row.size() < 2 || row.front() != '|' || row.back() != '|')
  {
    return {};
  }
  return Split(row.substr(1, row.size() - 2), '|');
}

PrintedNumber Parse(const std::string& text)
{
  const size_t point = text.find('.');
  const size_t decimals = point == std::string::npos ? 0 : text.size() - point - 1;
  return { std::stod(text), std::pow(10.0, -static_cast<double>(decimals)) };
}
}

ReflectionTable ReadReflectionTable(const std::string& heading)
{
  ReflectionTable table;
  std::ifstream document(PENUMBRA_REFLECTION_MODELS);
  for (std::string line; std::getline(document, line);)
  {
    const std::vector<std::string> cells = Cells(line);
    if (table.Angles.empty() && !cells.empty() && cells[0] == heading)
    {
      for (size_t column = 1; column < cells.size(); ++column)
      {
        table.Angles.push_back(std::stod(cells[column]));
      }
      std::getline(document, line); // the rule below the heading
    }
    else if (!table.Angles.empty() && cells.empty())
    {
      break;
    }
    else if (!table.Angles.empty())
    {
      ReflectionRow row;
      for (const std::string& parameter : Split(cells[0], ','))
      {
        row.Parameters.push_back(std::stod(parameter));
      }
      for (size_t column = 1; column < cells.size(); ++column)
      {
        row.Values.push_back(Parse(cells[column]));
      }
      table.Rows.push_back(row);
    }
  }
  return table;
}
