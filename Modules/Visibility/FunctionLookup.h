/**
 * @file    FunctionLookup.h
 * @brief   a function of one variable, looked up where that is accurate and else evaluated
 *
 * The range is cut into even cells. A cell over which a parabola through the function's values at
 * both ends and the middle keeps within RelativeTolerance of the function's own value, or within
 * AbsoluteTolerance, is that parabola. All others, those with a knot (where the function bends or
 * jumps) inside among them, ask the function. So steps and ramps of any steepness are exact.
 */

#ifndef FunctionLookup_h
#define FunctionLookup_h

#include <functional>
#include <vector>

namespace penumbra
{

class FunctionLookup
{
public:
  using Function = std::function<double(double)>;

  static constexpr double RelativeTolerance = 1e-6;
  static constexpr double AbsoluteTolerance = 1e-9;

  /// The function must allow calls from many threads at once.
  FunctionLookup(Function function, double low, double high, const std::vector<double>& knots);

  /// Beyond the range: the value at its end. NaN counts as low.
  double GetValue(double x) const
  {
    const double place = (x - this->Low) * this->CellsPerUnit;
    const double inside = place > 0.0 ? (place < this->LastPlace ? place : this->LastPlace) : 0.0;
    const Cell& cell = this->Cells[static_cast<std::size_t>(inside)];
    if (!cell.Parabola)
    {
      return this->Exact(this->Clamp(x));
    }
    const double u = inside - static_cast<double>(static_cast<int>(inside));
    return cell.Constant + u * (cell.Linear + u * cell.Quadratic);
  }

private:
  struct Cell
  {
    float Constant;
    float Linear;
    float Quadratic;
    bool Parabola;
  };

  double Clamp(double x) const
  {
    return x > this->Low ? (x < this->High ? x : this->High) : this->Low;
  }
  Cell MakeCell(double begin, double width) const;

  Function Exact;
  double Low;
  double High;
  double CellsPerUnit = 0.0;
  double LastPlace = 0.0;
  std::vector<Cell> Cells;
};

}

#endif
