/**
 * @file    TransferFunctionPoints.h
 * @brief   transfer functions as straight lines between their own points
 */

#ifndef TransferFunctionPoints_h
#define TransferFunctionPoints_h

#include "TransferFunctionTable.h"

#include <array>
#include <vector>

namespace penumbra
{

struct TransferFunctionPoint
{
  double Scalar;
  std::array<double, 4> ColorAndOpacity;
};

/// The scalars of all functions' points, ascending.
std::vector<double> GetPointScalars(const TransferFunctions& functions);

/// Whether all functions keep the values of their first and last point beyond them.
bool AreClamped(const TransferFunctions& functions);

/// Whether the functions are straight lines between their points, and constant beyond them.
bool ArePiecewiseLinear(const TransferFunctions& functions);

/// The functions' values at a scalar, approached from one side, so that a step has both its ends.
TransferFunctionPoint GetPoint(const TransferFunctions& functions, double scalar, bool fromBelow);

/// The points of all functions together at these ascending scalars; two where there is a step.
std::vector<TransferFunctionPoint> GetPoints(
  const TransferFunctions& functions, std::vector<double> scalars);

}

#endif
