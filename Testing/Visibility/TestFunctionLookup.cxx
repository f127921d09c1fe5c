#include "Catch.h"
#include "FunctionLookup.h"
#include "PiecewiseCurve.h"

#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>

#include <cmath>
#include <limits>

using namespace penumbra;

namespace
{
void AddPoints(vtkPiecewiseFunction* function, double midpoint, double sharpness)
{
  function->AllowDuplicateScalarsOn();
  function->AddPoint(10.0, 0.2, midpoint, sharpness);
  function->AddPoint(50.0, 0.0, midpoint, sharpness);
  function->AddPoint(60.0, 0.0, midpoint, sharpness);
  function->AddPoint(60.0, 0.9, midpoint, sharpness);
  function->AddPoint(61.5, 0.1, midpoint, sharpness);
  function->AddPoint(200.0, 0.8, midpoint, sharpness);
}
}

TEST_CASE("A curve has the values of VTK's function")
{
  vtkNew<vtkPiecewiseFunction> function;
  const double midpoint = GENERATE(0.5, 0.2);
  const double sharpness = GENERATE(0.0, 0.4, 1.0);
  AddPoints(function, midpoint, sharpness);
  function->SetClamping(GENERATE(0, 1));
  function->SetUseLogScale(GENERATE(false, true));
  const PiecewiseCurve curve(function);
  for (double x = 1.0; x < 220.0; x += 0.5)
  {
    CAPTURE(x);
    CHECK(curve.GetValue(x) == Approx(function->GetValue(x)).margin(1e-12));
  }
}

TEST_CASE("A curve of no points is 0, one of a single point constant where clamped")
{
  vtkNew<vtkPiecewiseFunction> function;
  CHECK(PiecewiseCurve(function).GetValue(3.0) == 0.0);
  function->AddPoint(5.0, 0.3);
  CHECK(PiecewiseCurve(function).GetValue(3.0) == 0.3);
  CHECK(PiecewiseCurve(function).GetValue(5.0) == 0.3);
  CHECK(PiecewiseCurve(function).GetValue(7.0) == 0.3);
  function->ClampingOff();
  CHECK(PiecewiseCurve(function).GetValue(3.0) == 0.0);
}

TEST_CASE("A curve is 0 between two scalars where neither they nor points in between are above")
{
  vtkNew<vtkPiecewiseFunction> function;
  AddPoints(function, 0.5, 0.0);
  const PiecewiseCurve curve(function);
  CHECK(curve.IsZeroBetween(50.0, 59.0));
  CHECK(curve.IsZeroBetween(55.0, 55.0));
  CHECK_FALSE(curve.IsZeroBetween(49.0, 55.0));
  CHECK_FALSE(curve.IsZeroBetween(55.0, 60.5));
  CHECK_FALSE(curve.IsZeroBetween(0.0, 5.0));
  // A step: interpolation comes as near to its upper side as it likes.
  CHECK_FALSE(curve.IsZeroBetween(55.0, 60.0));
  function->ClampingOff();
  CHECK(PiecewiseCurve(function).IsZeroBetween(0.0, 5.0));
  CHECK_FALSE(PiecewiseCurve(function).IsZeroBetween(0.0, 300.0));
}

TEST_CASE("A lookup keeps within its tolerances of the function")
{
  vtkNew<vtkPiecewiseFunction> function;
  AddPoints(function, 0.5, GENERATE(0.0, 0.9));
  const PiecewiseCurve curve(function);
  const auto depth = [&](double x) { return -std::log1p(-curve.GetValue(x)); };
  const double low = GENERATE(0.0, -1e6, 12.345);
  const double high = GENERATE(255.0, 65535.0, 1e9);
  const FunctionLookup lookup(depth, low, high, curve.GetKnots());
  for (double x = std::max(low, -10.0); x < 210.0; x += 0.00973)
  {
    const double exact = depth(x);
    const double tolerance =
      2.0 * (FunctionLookup::RelativeTolerance * exact + FunctionLookup::AbsoluteTolerance);
    CAPTURE(x, lookup.GetValue(x), exact);
    REQUIRE(std::abs(lookup.GetValue(x) - exact) <= tolerance);
  }
}

TEST_CASE("A lookup hardly ever asks a smooth function")
{
  int calls = 0;
  const auto depth = [&](double x)
  {
    ++calls;
    return -std::log1p(-x);
  };
  const FunctionLookup lookup(depth, 0.0, 0.9, { 0.0, 0.5, 0.9 });
  calls = 0;
  constexpr int samples = 10000;
  for (int sample = 0; sample < samples; ++sample)
  {
    lookup.GetValue(0.9 * sample / samples);
  }
  CHECK(calls < samples / 1000);
}

TEST_CASE("A lookup's range may be as large or as small as numbers are")
{
  const auto step = [](double x) { return x > 1e-320 ? 1.0 : 0.0; };
  const double largest = std::numeric_limits<double>::max();
  const FunctionLookup huge(step, -largest, largest, { 1e-320 });
  CHECK(huge.GetValue(-1.0) == 0.0);
  CHECK(huge.GetValue(1.0) == 1.0);
  const FunctionLookup tiny(step, 0.0, 2e-320, { 1e-320 });
  CHECK(tiny.GetValue(0.5e-320) == 0.0);
  CHECK(tiny.GetValue(1.5e-320) == 1.0);
}

TEST_CASE("Beyond its range a lookup keeps the value of its end, and NaN counts as the low one")
{
  const FunctionLookup lookup([](double x) { return x * x; }, 2.0, 3.0, {});
  CHECK(lookup.GetValue(-5.0) == Approx(4.0));
  CHECK(lookup.GetValue(7.0) == Approx(9.0));
  CHECK(lookup.GetValue(std::nan("")) == Approx(4.0));
  const FunctionLookup constant([](double x) { return x * x; }, 2.0, 2.0, {});
  CHECK(constant.GetValue(-5.0) == 4.0);
  CHECK(constant.GetValue(std::nan("")) == 4.0);
}
