#include "ShadowEdge.h"

#include "LevelCrossings.h" // For FindZero

#include <algorithm>
#include <cmath>

namespace penumbra::reference
{
namespace
{
// The parabola is off by less than this share of its samples' range, where they show the margin.
constexpr double Doubt = 0.25;

// A margin of 0 is no shadow: with a threshold of 0 it is 0 wherever there is none.
constexpr double LeastMargin = 1e-12;

bool IsInShadow(double margin)
{
  return margin > 0.0;
}

/// Through three samples, in Newton's form.
struct Parabola
{
  MarginSample Origin;
  double SecondPosition;
  double Slope;
  double Curvature;

  Parabola(const MarginSample& a, const MarginSample& b, const MarginSample& c)
    : Origin(a)
    , SecondPosition(b.Position)
    , Slope((b.Margin - a.Margin) / (b.Position - a.Position))
    , Curvature(
        ((c.Margin - b.Margin) / (c.Position - b.Position) - Slope) / (c.Position - a.Position))
  {
  }

  double At(double x) const
  {
    return this->Origin.Margin +
      (x - this->Origin.Position) * (this->Slope + this->Curvature * (x - this->SecondPosition));
  }

  /// Not finite where it is a straight line.
  double GetTurningPoint() const
  {
    return 0.5 * (this->Origin.Position + this->SecondPosition - this->Slope / this->Curvature);
  }
};
}

//------------------------------------------------------------------------------
ShadowEdge::ShadowEdge(const std::vector<MarginSample>& samples, double begin, double end)
  : Samples(samples)
  , Begin(begin)
  , End(end)
{
}

//------------------------------------------------------------------------------
void ShadowEdge::AppendSuspects(std::size_t first, std::vector<Suspect>& suspects) const
{
  const auto* triple = this->Samples.data() + first;
  const Parabola parabola(triple[0], triple[1], triple[2]);
  const auto [low, high] = std::minmax({ triple[0].Margin, triple[1].Margin, triple[2].Margin });
  const double doubt = Doubt * (high - low);
  const auto append = [&](double position, std::size_t neighbour)
  {
    const double margin = parabola.At(position);
    if (IsInShadow(triple[1].Margin) ? margin < doubt : margin > -doubt)
    {
      suspects.push_back({ position, neighbour });
    }
  };
  const double turning = parabola.GetTurningPoint();
  if (turning > triple[0].Position && turning < triple[2].Position)
  {
    append(turning, first + 1);
  }
  if (first == 0)
  {
    append(this->Begin, 0);
  }
  if (first + 3 == this->Samples.size())
  {
    append(this->End, this->Samples.size() - 1);
  }
}

//------------------------------------------------------------------------------
std::vector<ShadowEdge::Suspect> ShadowEdge::GetSuspects() const
{
  std::vector<Suspect> suspects;
  for (std::size_t first = 0; first + 2 < this->Samples.size(); ++first)
  {
    this->AppendSuspects(first, suspects);
  }
  return suspects;
}

//------------------------------------------------------------------------------
std::optional<double> ShadowEdge::Find(const MarginFunction& getMargin, double resolution) const
{
  const auto getSide = [&](double position)
  {
    const double margin = getMargin(position);
    return IsInShadow(margin) ? margin : std::min(margin, -LeastMargin);
  };
  const auto find = [&](double a, double b)
  { return FindZero(getSide, std::min(a, b), std::max(a, b), resolution); };
  for (std::size_t i = 0; i + 1 < this->Samples.size(); ++i)
  {
    if (IsInShadow(this->Samples[i].Margin) != IsInShadow(this->Samples[i + 1].Margin))
    {
      return find(this->Samples[i].Position, this->Samples[i + 1].Position);
    }
  }
  for (const Suspect& suspect : this->GetSuspects())
  {
    const MarginSample& neighbour = this->Samples[suspect.Neighbour];
    if (IsInShadow(getMargin(suspect.Position)) != IsInShadow(neighbour.Margin))
    {
      return find(suspect.Position, neighbour.Position);
    }
  }
  return std::nullopt;
}

}
