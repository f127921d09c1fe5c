/**
 * @file    PiecewiseLinear.h
 * @brief   functions that are linear between points
 */

#ifndef PiecewiseLinear_h
#define PiecewiseLinear_h

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace penumbra::reference
{

/**
 * A function of one number with N values. Before the first and after the last point it keeps the
 * value of that one. Two points at one x are a step; at x itself the function has the value of the
 * first of them, as vtkPiecewiseFunction has. Without points it is 0.
 */
template <std::size_t N>
class PiecewiseLinear
{
public:
  using Value = std::array<double, N>;

  /// What the function is between two neighbouring points.
  struct Line
  {
    double Start = 0.0;
    Value AtStart{};
    Value Slope{};

    double At(double x, std::size_t channel = 0) const
    {
      return this->AtStart[channel] + this->Slope[channel] * (x - this->Start);
    }
  };

  PiecewiseLinear()
    : Lines(1)
  {
  }

  /// The next point; x does not descend.
  void AddPoint(double x, const Value& value)
  {
    Line& between = this->Lines.back();
    if (this->Levels.empty())
    {
      between = Line{ x, value, {} };
    }
    else
    {
      const double width = x - between.Start;
      for (std::size_t channel = 0; channel < N; ++channel)
      {
        const double rise = value[channel] - between.AtStart[channel];
        between.Slope[channel] = width > 0.0 ? rise / width : 0.0;
      }
    }
    this->Levels.push_back(x);
    this->Lines.push_back(Line{ x, value, {} });
  }

  const Line& GetLine(double x) const { return this->Lines[this->GetLineNumber(x)]; }
  std::size_t GetLineNumber(double x) const
  {
    return std::lower_bound(this->Levels.begin(), this->Levels.end(), x) - this->Levels.begin();
  }

  /// One more than levels: line i holds from level i - 1, exclusive, to level i.
  const std::vector<Line>& GetLines() const { return this->Lines; }
  /// The points' x, ascending.
  const std::vector<double>& GetLevels() const { return this->Levels; }

private:
  std::vector<double> Levels;
  std::vector<Line> Lines;
};

}

#endif
