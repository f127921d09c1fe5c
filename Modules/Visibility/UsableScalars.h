/**
 * @file    UsableScalars.h
 * @brief   a volume's scalars, finite and in one piece
 */

#ifndef UsableScalars_h
#define UsableScalars_h

#include "vtkSmartPointer.h"

class vtkDataArray;

namespace penumbra
{

struct UsableScalars
{
  /// The array itself, or a copy where its memory layout or its values made one necessary.
  vtkSmartPointer<vtkDataArray> Array;
  double Low = 0.0;
  double High = 0.0;
  /// Whether NaN and -Inf were replaced by the smallest finite value, +Inf by the largest.
  bool Replaced = false;
};

/// The first component must be the only one.
UsableScalars MakeUsableScalars(vtkDataArray* scalars);

}

#endif
