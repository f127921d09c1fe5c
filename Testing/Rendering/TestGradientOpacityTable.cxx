#include "Catch.h"
#include "GradientOpacityTable.h"

#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace penumbra;

namespace
{
// As GradientOpacityTable.glsl.
double LookUpGradient(const GradientOpacityTable& table, double gradient)
{
  const double last = static_cast<double>(table.Opacity.size() - 1);
  const double inRange = std::clamp((gradient - table.Low) / (table.High - table.Low), 0.0, 1.0);
  const double entry = std::sqrt(inRange) * last;
  const auto low = static_cast<size_t>(std::min(entry, last - 1.0));
  const double fraction = entry - static_cast<double>(low);
  return (1.0 - fraction) * table.Opacity[low] + fraction * table.Opacity[low + 1];
}
}

TEST_CASE("A gradient opacity table covers its points and keeps their values beyond")
{
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(5.0, 0.25);
  function->AddPoint(45.0, 0.75);
  const GradientOpacityTable table = MakeGradientOpacityTable(function, 401, 1e9);
  CHECK(table.Low == 5.0);
  CHECK(table.High == 45.0);
  REQUIRE(table.Opacity.size() == 401);
  CHECK(table.Opacity.front() == 0.25f);
  // Half the way to the last entry is a quarter of the way to the last point.
  CHECK(table.Opacity[200] == Approx(0.375));
  CHECK(table.Opacity.back() == Approx(0.75));
}

TEST_CASE("A gradient opacity that hardly changes beyond a small gradient keeps the ramp before")
{
  for (const double last : { 1.0, 0.98 })
  {
    // Half a grey level; where the table reaches to the last point, a quarter of a cell at the
    // ramp's end, 0.06 wide.
    const double tolerance = last == 1.0 ? 0.002 : 0.016;
    vtkNew<vtkPiecewiseFunction> function;
    function->AddPoint(0.0, 0.0);
    function->AddPoint(96.0, 0.0);
    function->AddPoint(97.0, 1.0);
    function->AddPoint(60000.0, last);
    const GradientOpacityTable table = MakeGradientOpacityTable(function, 8192, 85000.0);
    for (const double gradient : { 0.0, 96.0, 96.25, 96.5, 97.0, 5000.0, 1e6 })
    {
      INFO("at " << gradient << " of a function that ends at " << last);
      CHECK(
        LookUpGradient(table, gradient) == Approx(function->GetValue(gradient)).margin(tolerance));
    }
  }
}

TEST_CASE("A gradient opacity table goes no further than the largest gradient")
{
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(0.0, 0.0);
  function->AddPoint(10.0, 0.9);
  function->AddPoint(1e9, 1.0);
  const GradientOpacityTable table = MakeGradientOpacityTable(function, 401, 100.0);
  CHECK(table.High == 100.0);
  CHECK(table.Opacity[40] == Approx(0.09));
}

TEST_CASE("A gradient opacity function of one value, or of none, is a table of it")
{
  vtkNew<vtkPiecewiseFunction> function;
  const GradientOpacityTable none = MakeGradientOpacityTable(function, 16, 1e9);
  CHECK(none.Opacity == std::vector<float>(16, 1.0f));
  function->AddPoint(7.0, 0.5);
  const GradientOpacityTable constant = MakeGradientOpacityTable(function, 16, 1e9);
  CHECK(constant.Opacity == std::vector<float>(16, 0.5f));
  CHECK(constant.High > constant.Low);
}

TEST_CASE("Beyond a step at the end of a gradient opacity there is its outer side")
{
  vtkNew<vtkPiecewiseFunction> rising;
  rising->AllowDuplicateScalarsOn();
  rising->AddPoint(10.0, 0.2);
  rising->AddPoint(10.0, 1.0);
  const GradientOpacityTable risen = MakeGradientOpacityTable(rising, 8192, 1e9);
  CHECK(LookUpGradient(risen, 9.9) == Approx(0.2));
  CHECK(LookUpGradient(risen, 10.1) == Approx(1.0));
  vtkNew<vtkPiecewiseFunction> falling;
  falling->AllowDuplicateScalarsOn();
  falling->AddPoint(0.0, 0.2);
  falling->AddPoint(40.0, 0.6);
  falling->AddPoint(40.0, 0.0);
  const GradientOpacityTable fallen = MakeGradientOpacityTable(falling, 8192, 1e9);
  CHECK(LookUpGradient(fallen, 39.0) == Approx(0.59));
  CHECK(LookUpGradient(fallen, 41.0) == 0.0);
}

TEST_CASE("The least visible gradient is where gradient opacity begins to rise")
{
  GradientOpacityTable table;
  table.Low = 2.0;
  table.High = 10.0;
  table.Opacity = { 0, 0, 0, 0.1f, 1 };
  // Entries are even in the root of the distance from Low; the third is the last that is 0.
  CHECK(FindLeastVisibleGradient(table) == Approx(2.0 + 0.25 * 8.0));
  table.Opacity = { 0.1f, 0, 0 };
  CHECK(FindLeastVisibleGradient(table) == 0.0);
  table.Opacity = { 0, 0, 0 };
  CHECK(FindLeastVisibleGradient(table) == std::numeric_limits<double>::infinity());
}
