/**
 * @file    LevelCrossings.h
 * @brief   where exactly a polynomial on [0, 1] crosses given levels
 *
 * A transfer function's points are levels of the scalar field. Crossings are isolated in
 * Bernstein's form: the polynomial lies in the range of the coefficients (convex hull), and is
 * monotonic where they are. So none is overlooked, however narrow a transfer function's peak is.
 */

#ifndef LevelCrossings_h
#define LevelCrossings_h

#include "Polynomial.h"

#include <cmath>
#include <vector>

namespace penumbra::reference
{

/// Where a function changes its sign between `low` and `high`, at which it has different ones, to
/// this resolution: regula falsi of the Illinois kind, bisection where that is slow.
template <typename Function>
double FindZero(Function function, double low, double high, double resolution = 1e-15)
{
  constexpr int FastSteps = 16;
  constexpr int MostSteps = 80;
  double atLow = function(low);
  double atHigh = function(high);
  int lastSide = 0;
  for (int step = 0; step < MostSteps && high - low > resolution; ++step)
  {
    const double secant = (low * atHigh - high * atLow) / (atHigh - atLow);
    // Never at an end: then the bracket could not close.
    const double middle = step < FastSteps
      ? std::clamp(secant, low + 0.5 * resolution, high - 0.5 * resolution)
      : 0.5 * (low + high);
    const double value = function(middle);
    const int side = (value < 0.0) == (atLow < 0.0) ? -1 : 1;
    const double weight = side == lastSide ? 0.5 : 1.0;
    if (side < 0)
    {
      low = middle;
      atLow = value;
      atHigh *= weight;
    }
    else
    {
      high = middle;
      atHigh = value;
      atLow *= weight;
    }
    lastSide = side;
  }
  return 0.5 * (low + high);
}

template <int Degree>
class CrossingSearch
{
public:
  CrossingSearch(const Polynomial<Degree>& polynomial, const std::vector<double>& levels,
    std::vector<double>& crossings)
    : Searched(polynomial)
    , Levels(levels)
    , Crossings(crossings)
  {
  }

  using Bernstein = std::array<double, Degree + 1>;

  void Search(const Bernstein& bernstein, double begin, double end, int halvings)
  {
    const auto [low, high] = std::minmax_element(bernstein.begin(), bernstein.end());
    auto level = std::upper_bound(this->Levels.begin(), this->Levels.end(), *low);
    if (level == this->Levels.end() || *level >= *high)
    {
      return;
    }
    const bool rises = std::is_sorted(bernstein.begin(), bernstein.end());
    if (rises || std::is_sorted(bernstein.rbegin(), bernstein.rend()))
    {
      for (; level != this->Levels.end() && *level < *high; ++level)
      {
        this->Crossings.push_back(
          FindZero([&](double u) { return this->Searched.At(u) - *level; }, begin, end));
      }
    }
    else if (halvings > 0)
    {
      this->SearchHalves(bernstein, begin, end, halvings - 1);
    }
  }

private:
  /// De Casteljau's subdivision.
  void SearchHalves(Bernstein bernstein, double begin, double end, int halvings)
  {
    Bernstein first{};
    for (int i = 0; i <= Degree; ++i)
    {
      first[i] = bernstein[0];
      for (int k = 0; k < Degree - i; ++k)
      {
        bernstein[k] = 0.5 * (bernstein[k] + bernstein[k + 1]);
      }
    }
    const double middle = 0.5 * (begin + end);
    this->Search(first, begin, middle, halvings);
    // What is left in place are the second half's coefficients.
    this->Search(bernstein, middle, end, halvings);
  }

  const Polynomial<Degree>& Searched;
  const std::vector<double>& Levels;
  std::vector<double>& Crossings;
};

/**
 * Appends where the polynomial passes one of the levels, which ascend. Where it only touches one,
 * or within 1e-9 of two crossings of one, some may be missing.
 */
template <int Degree>
void AppendCrossings(const Polynomial<Degree>& polynomial, const std::vector<double>& levels,
  std::vector<double>& crossings)
{
  constexpr int MostHalvings = 30;
  CrossingSearch<Degree>(polynomial, levels, crossings)
    .Search(ToBernstein(polynomial), 0.0, 1.0, MostHalvings);
}

}

#endif
