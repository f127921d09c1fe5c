/**
 * @file ReflectionTables.h
 * @brief The tables of ReflectionModels.md.
 */
#ifndef ReflectionTables_h
#define ReflectionTables_h

#include <string>
#include <vector>

/// A number as printed: its value and the unit of its last digit.
struct PrintedNumber
{
  double Value;
  double Unit;
};

struct ReflectionRow
{
  std::vector<double> Parameters;
  std::vector<PrintedNumber> Values;
};

struct ReflectionTable
{
  std::vector<double> Angles; ///< degrees, of the columns
  std::vector<ReflectionRow> Rows;
};

/// The table whose first column has that heading. Without rows where there is none.
ReflectionTable ReadReflectionTable(const std::string& heading);

#endif
