/**
 * @class   ChartMeasures
 * @brief   the sizes of what stands in a chart
 *
 * All follow that of the type, which follows that of the chart, so that a chart looks the same at
 * every size.
 */

#ifndef ChartMeasures_h
#define ChartMeasures_h

#include "ChartLook.h"
#include "SheetText.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{

struct ChartMeasures
{
  ChartMeasures(int width, int height)
    : Type(std::max(9.0, 13.0 * std::min(width / 900.0, height / 600.0)))
  {
  }

  TypeStyle Style(double factor, const ChartColor& color, bool isBold = false) const
  {
    return { static_cast<int>(std::lround(factor * this->Type)), isBold, color };
  }

  double Type;

  TypeStyle Title = this->Style(1.4, ChartInk, true);
  TypeStyle BelowTitle = this->Style(1.0, ChartSmallInk);
  TypeStyle AxisTitle = this->Style(1.0, ChartInk);
  TypeStyle Tick = this->Style(1.0, ChartSmallInk);
  TypeStyle Legend = this->Style(1.0, ChartInk);
  TypeStyle Label = this->Style(0.88, ChartSmallInk);

  double Margin = 1.5 * this->Type;
  double LineWidth = this->Type / 13.0;
  double CurveWidth = 1.45 * this->LineWidth;
  double MarkerRadius = 0.36 * this->Type;
  double TickLength = 0.35 * this->Type;
};

}

#endif
