/**
 * @file    VisibleScalars.h
 * @brief   the scalars to which the opacity function, as it is looked up, gives any opacity
 */

#ifndef VisibleScalars_h
#define VisibleScalars_h

#include "PenumbraRenderingModule.h" // For export macro
#include "TransferFunctionTable.h"

#include <array>
#include <vector>

namespace penumbra
{

/// Disjoint closed intervals, ascending. An opacity that is not quite 0 counts as visible.
class PENUMBRARENDERING_EXPORT VisibleScalars
{
public:
  VisibleScalars() = default;
  /// Between an entry of the table, or a point, that is not 0 and the next that is, interpolation
  /// gives some opacity; beyond the ends the first and last value hold on.
  explicit VisibleScalars(const TransferFunctionTable& table);

  bool AnyBetween(double low, double high) const;

private:
  std::vector<std::array<double, 2>> Intervals;
};

}

#endif
