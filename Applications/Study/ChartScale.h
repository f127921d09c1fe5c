/**
 * @class   ChartScale
 * @brief   where on an axis of a chart a value lies
 *
 * Positions run from 0 at the axis's beginning to 1 at its end. VTK's own logarithmic axes convert
 * the values to float before they take the logarithm; here all is done in double, and VTK is given
 * positions.
 */

#ifndef ChartScale_h
#define ChartScale_h

#include <vector>

namespace penumbra
{

/// Finite, and positive where the axis is logarithmic.
bool CanShow(double value, bool isLogarithmic);

class ChartScale
{
public:
  /// Spans what it can show of the points, with a margin, and of the guides what lies within a
  /// quarter of that span.
  ChartScale(
    const std::vector<double>& points, const std::vector<double>& guides, bool isLogarithmic);

  bool IsLogarithmic() const { return this->Logarithmic; }

  /// Only for values that it can show.
  double PositionOf(double value) const;

  /// Whether the value can be shown and lies between the axis's ends.
  bool Contains(double value) const;

  /**
   * The ends of the axis in what positions are proportional to: the logarithm of the value to base
   * 10, or an eighth of the value, so that the difference of the largest numbers is finite.
   */
  double GetLowest() const { return this->Lowest; }
  double GetHighest() const { return this->Highest; }
  double Measure(double value) const;

private:
  bool Logarithmic;
  double Lowest = 0.0;
  double Highest = 1.0;
};

}

#endif
