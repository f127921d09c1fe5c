/**
 * @file    ShadowEdge.h
 * @brief   where along a view ray a hard shadow begins or ends
 */

#ifndef ShadowEdge_h
#define ShadowEdge_h

#include <functional>
#include <optional>
#include <vector>

namespace penumbra::reference
{

/// By how much at a position the optical depth towards the light exceeds what makes the shadow.
using MarginFunction = std::function<double(double)>;

struct MarginSample
{
  double Position;
  double Margin;
};

/**
 * A change of the margin's sign between `begin` and `end`, if there is one. Samples on either side
 * of an edge show it; and as the margin itself is continuous, the parabola through three of them
 * shows where there may be one between them or beyond, where it is looked for.
 */
class ShadowEdge
{
public:
  /// At least three samples, ascending.
  ShadowEdge(const std::vector<MarginSample>& samples, double begin, double end);

  std::optional<double> Find(const MarginFunction& getMargin, double resolution) const;

private:
  struct Suspect
  {
    double Position;
    /// A sample beside it.
    std::size_t Neighbour;
  };

  std::vector<Suspect> GetSuspects() const;
  void AppendSuspects(std::size_t first, std::vector<Suspect>& suspects) const;

  const std::vector<MarginSample>& Samples;
  double Begin;
  double End;
};

}

#endif
