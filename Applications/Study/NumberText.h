/**
 * @file    NumberText.h
 * @brief   numbers as tables show them
 */

#ifndef NumberText_h
#define NumberText_h

#include <iomanip>
#include <sstream>
#include <string>

namespace penumbra
{

/// Rounded to this many digits after the point.
inline std::string Fixed(double value, int digits)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

}

#endif
