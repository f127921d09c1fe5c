#include "Catch.h"
#include "MakeArray.h"
#include "ScalarRange.h"

#include <vtkFloatArray.h>
#include <vtkNew.h>

#include <cmath>
#include <limits>

using namespace penumbra;

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
}

TEST_CASE("The range is that of the finite values")
{
  const double nan = std::nan("");
  const ScalarRange range =
    ComputeScalarRange(MakeArray(VTK_DOUBLE, { nan, 3.0, -Infinity, -2.0, Infinity, 7.0, nan }));
  CHECK(range.Low == -2.0);
  CHECK(range.High == 7.0);
  CHECK_FALSE(range.AllFinite);
  CHECK(ComputeScalarRange(MakeArray(VTK_FLOAT, { 5.0, 4.0 })).AllFinite);
  const ScalarRange nothing = ComputeScalarRange(MakeArray(VTK_FLOAT, { nan, Infinity }));
  CHECK((nothing.Low == 0.0 && nothing.High == 0.0 && !nothing.AllFinite));
}

TEST_CASE("The range of a large array is found wherever its extremes are")
{
  vtkNew<vtkFloatArray> scalars;
  scalars->SetNumberOfTuples(1000000);
  scalars->Fill(1.0);
  for (const vtkIdType place : { 0, 499999, 999999 })
  {
    scalars->SetValue(place, 8.0f);
    scalars->SetValue(999999 - place, -8.0f);
    const ScalarRange range = ComputeScalarRange(scalars);
    CHECK((range.Low == -8.0 && range.High == 8.0));
    scalars->Fill(1.0);
  }
}
