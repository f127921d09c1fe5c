/**
 * @file    GradientDifferences.h
 * @brief   the gradients of whole scalars, exact in 16 bits
 *
 * All estimators weigh by whole numbers before they divide: of whole scalars their differences are
 * whole too, and a texture of 16 bits holds them without any rounding, as far as they fit.
 */

#ifndef GradientDifferences_h
#define GradientDifferences_h

#include "LightingRequirements.h"

#include "vtkSmartPointer.h"

#include <array>

class vtkDataArray;
class vtkShortArray;

namespace penumbra
{

struct ScalarRange;

/// Whether 16 bits hold the differences of scalars of this type (VTK_SHORT...) and range.
bool AreDifferencesExact(int scalarType, const ScalarRange& range, GradientEstimator estimator);

/// Three a voxel, x fastest.
vtkSmartPointer<vtkShortArray> ComputeGradientDifferences(
  vtkDataArray* scalars, const std::array<int, 3>& dimensions, GradientEstimator estimator);

/// Of gradients (GradientField.h), in a signed normalized texture of such differences: gradient =
/// scale * value / 32767.
double GetDifferenceScale(GradientEstimator estimator);

}

#endif
