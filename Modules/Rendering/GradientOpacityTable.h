/**
 * @file    GradientOpacityTable.h
 * @brief   a gradient opacity function as a table
 */

#ifndef GradientOpacityTable_h
#define GradientOpacityTable_h

#include "PenumbraRenderingModule.h" // For export macro

#include <vector>

class vtkPiecewiseFunction;

namespace penumbra
{

/// A table of a gradient opacity function between the points where it begins and ceases to change,
/// and no further than the largest gradient. It is even in the root of the distance from Low: such
/// functions rise at gradients that are small against the largest. Ramps narrower than its cells
/// are smoothed.
struct GradientOpacityTable
{
  double Low = 0.0;
  double High = 0.0;
  std::vector<float> Opacity;
};

PENUMBRARENDERING_EXPORT GradientOpacityTable MakeGradientOpacityTable(
  vtkPiecewiseFunction* function, int size, double largestGradient);

/// The least magnitude to which a table of gradient opacity gives any opacity; infinite where there
/// is none.
PENUMBRARENDERING_EXPORT double FindLeastVisibleGradient(const GradientOpacityTable& table);

}

#endif
