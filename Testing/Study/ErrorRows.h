/**
 * @file ErrorRows.h
 * @brief Rows of the error study with known errors.
 */
#ifndef ErrorRows_h
#define ErrorRows_h

#include "ErrorStudy.h"

#include <cmath>

namespace penumbra
{
inline ErrorRow Row(const std::string& variant, double step, double rmse, double cpu)
{
  ErrorRow row;
  row.Scene = "scene";
  row.Variant = variant;
  row.Step = step;
  row.Error.RootMeanSquare = rmse;
  row.CpuSeconds = cpu;
  row.Relative = 2.0 * cpu;
  return row;
}

/// Errors that fall as a power of the step from 4 to 1/16, with this much rounding.
inline std::vector<ErrorRow> RowsOfOrder(double order, double rounding)
{
  std::vector<ErrorRow> rows;
  for (double step = 4.0; step > 0.05; step *= 0.5)
  {
    const double error = 16.0 * std::pow(step / 4.0, order);
    rows.push_back(Row("penumbra rays", step, std::hypot(error, rounding), 1.0 / step));
  }
  return rows;
}
}

#endif
