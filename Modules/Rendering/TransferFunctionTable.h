/**
 * @file    TransferFunctionTable.h
 * @brief   transfer functions as tables, or as their own points where no table is accurate
 *
 * A table is even in the scalar and holds extinction and colour. It is accepted where, between its
 * entries, it keeps the extinction and the colour within the tolerances stated in the source.
 * Functions that no table of the largest size can hold (steps and ramps much narrower than the
 * range of their points) are evaluated exactly, by a search among their points.
 */

#ifndef TransferFunctionTable_h
#define TransferFunctionTable_h

#include "LightingRequirements.h"
#include "PenumbraRenderingModule.h" // For export macro

#include <vector>

class vtkColorTransferFunction;
class vtkPiecewiseFunction;

namespace penumbra
{

struct TransferFunctions
{
  vtkPiecewiseFunction* Opacity = nullptr;
  /// One of the two; a gray function gives all three channels.
  vtkColorTransferFunction* Color = nullptr;
  vtkPiecewiseFunction* Gray = nullptr;
  double UnitDistance = 1.0;
  double DataLow = 0.0; ///< the volume's finite range
  double DataHigh = 0.0;
  bool IntegerData = false;
  /// Length of a step, by which to tell whether the functions are steep.
  double Step = 1.0;
};

/// Extinction per length of matter whose opacity per unit distance this is (MODEL: at most 1 -
/// 2^-24).
PENUMBRARENDERING_EXPORT double ComputeExtinction(double opacity, double unitDistance);

struct TransferFunctionTable
{
  TransferFunctionLookup Lookup = TransferFunctionLookup::Table;
  /// False where the functions change faster than the largest table can follow, and have too many
  /// points.
  bool Accurate = true;
  double Low = 0.0; ///< scalar of the first entry
  double High = 0.0;
  std::vector<float> Extinction; ///< with Points, as near as a table comes
  std::vector<float> Color;      ///< 3 an entry
  /// Integrals from the first entry to this one, over the coordinate u of a texture of the
  /// table, of extinction s and colour C.
  std::vector<float> ExtinctionIntegral; ///< of s
  std::vector<float> ColorIntegral;      ///< of s C, 3 an entry
  /// The functions change so fast that a step's middle does not tell what the step passes. Their
  /// integrals over the table are right even where the table itself is not.
  bool Steep = false;
  std::vector<double> PointScalars; ///< Points: relative to Low, ascending; both ends of a step
  std::vector<float> PointColors;   ///< Points: colour and opacity, 4 a point

  int GetSize() const { return static_cast<int>(this->Extinction.size()); }
  int GetNumberOfPoints() const { return static_cast<int>(this->PointScalars.size()); }
};

PENUMBRARENDERING_EXPORT TransferFunctionTable MakeTransferFunctionTable(
  const TransferFunctions& functions, int largestSize);

}

#endif
