/**
 * @file    ScalarRange.h
 * @brief   the finite values of a volume's scalars
 */

#ifndef ScalarRange_h
#define ScalarRange_h

class vtkDataArray;

namespace penumbra
{

/// Smallest and largest finite value of an array's first component, and whether all are finite.
/// Without any finite value both are 0.
struct ScalarRange
{
  double Low = 0.0;
  double High = 0.0;
  bool AllFinite = true;
};

ScalarRange ComputeScalarRange(vtkDataArray* scalars);

}

#endif
