/**
 * @file TransferFunctionLookup.h
 * @brief Transfer functions as a program looks them up, and what VTK says that they are.
 */
#ifndef TransferFunctionLookup_h
#define TransferFunctionLookup_h

#include "TransferFunctionTable.h"

#include <vtkColorTransferFunction.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>

#include <array>
#include <initializer_list>
#include <utility>

namespace penumbra
{
struct Matter
{
  double extinction = 0.0;
  std::array<double, 3> color{};
};

/// Linear between entries or points and constant beyond them, as OpacityTable.glsl and
/// OpacityPoints.glsl.
Matter LookUp(const TransferFunctionTable& table, double scalar, double unitDistance);

/// What VTK says of functions that hold no step at the scalar.
Matter Evaluate(const TransferFunctions& functions, double scalar);

/// Transfer functions of float data from 0 to 255, black to white over that range; points may share
/// a scalar.
struct OwnedFunctions
{
  vtkNew<vtkPiecewiseFunction> opacity;
  vtkNew<vtkColorTransferFunction> color;
  TransferFunctions functions;

  explicit OwnedFunctions(std::initializer_list<std::pair<double, double>> opacityPoints);
  void SetRange(double low, double high);
  /// The table, at most of the size that the mapper allows.
  TransferFunctionTable MakeTable() const;
};
}

#endif
