/**
 * @file    ChartText.h
 * @brief   texts that VTK can draw, in the room that there is
 */

#ifndef ChartText_h
#define ChartText_h

#include "SheetText.h"

#include <string>

class vtkTextProperty;

namespace penumbra
{

/// At which a size in points is one in pixels.
constexpr int ChartDotsPerInch = 72;

/// A "?" for each letter that VTK's typeface does not have: all but printable ASCII and line
/// breaks. VTK would leave them out.
std::string InTypeface(const std::string& text);

/// The text on one line that is no wider than that; where it would be, "..." stands for its end.
TextLine FitInto(double width, const std::string& text, const TypeStyle& style);

/**
 * In a chart that is drawn `scale` times as large. The property is not to be changed afterwards but
 * for its justification.
 */
void SetType(const TypeStyle& style, double scale, vtkTextProperty* property);

}

#endif
