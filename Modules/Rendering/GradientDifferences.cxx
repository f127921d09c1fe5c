#include "GradientDifferences.h"

#include "GradientRows.h"
#include "ScalarRange.h"

#include "vtkDataArray.h"
#include "vtkShortArray.h"

namespace penumbra
{
namespace
{
constexpr double LargestShort = 32767.0;

// Of the weights of values that lie ahead: of one value, or of Sobel's nine.
double GetSumOfWeights(GradientEstimator estimator)
{
  return estimator == GradientEstimator::Sobel ? 22.0 : 1.0;
}
}

//------------------------------------------------------------------------------
bool AreDifferencesExact(int scalarType, const ScalarRange& range, GradientEstimator estimator)
{
  // Ints hold Sobel's sums of them, of weights of 25 on the way.
  constexpr double largestWhole = 8e7;
  return scalarType != VTK_FLOAT && scalarType != VTK_DOUBLE && range.High <= largestWhole &&
    range.Low >= -largestWhole &&
    GetSumOfWeights(estimator) * (range.High - range.Low) <= LargestShort;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkShortArray> ComputeGradientDifferences(
  vtkDataArray* scalars, const std::array<int, 3>& dimensions, GradientEstimator estimator)
{
  auto differences = vtkSmartPointer<vtkShortArray>::New();
  differences->SetNumberOfComponents(3);
  differences->SetNumberOfTuples(scalars->GetNumberOfTuples());
  ForEachRow<int>(scalars, dimensions, estimator,
    [&](vtkIdType row, vtkIdType, const std::array<Row<int>, 3>& components)
    {
      short* difference = differences->GetPointer(3 * row * dimensions[0]);
      for (int x = 0; x < dimensions[0]; ++x)
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          difference[3 * x + axis] = static_cast<short>(components[axis][x]);
        }
      }
    });
  return differences;
}

//------------------------------------------------------------------------------
double GetDifferenceScale(GradientEstimator estimator)
{
  return LargestShort / GetDifferenceDivisor(estimator);
}

}
