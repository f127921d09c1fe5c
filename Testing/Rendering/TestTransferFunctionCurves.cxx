#include "Catch.h"
#include "TransferFunctionLookup.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

using namespace penumbra;

namespace
{
struct Curve
{
  const char* name;
  std::function<void(OwnedFunctions&)> bend;
};

// What makes a function more than straight lines between its points.
const std::vector<Curve> Curves = {
  { "HSV", [](OwnedFunctions& owned) { owned.color->SetColorSpaceToHSV(); } },
  { "Lab", [](OwnedFunctions& owned) { owned.color->SetColorSpaceToLab(); } },
  { "diverging", [](OwnedFunctions& owned) { owned.color->SetColorSpaceToDiverging(); } },
  { "logarithmic colour", [](OwnedFunctions& owned) { owned.color->SetScaleToLog10(); } },
  { "bent colour",
    [](OwnedFunctions& owned) { owned.color->AddRGBPoint(128.0, 0.0, 1.0, 0.0, 0.3, 0.6); } },
  { "bent opacity", [](OwnedFunctions& owned) { owned.opacity->AddPoint(128.0, 0.4, 0.2, 0.7); } },
  { "logarithmic opacity", [](OwnedFunctions& owned) { owned.opacity->UseLogScaleOn(); } },
};

OwnedFunctions& SetUp(OwnedFunctions& owned)
{
  owned.color->RemoveAllPoints();
  owned.color->AddRGBPoint(1.0, 0.8, 0.1, 0.1);
  owned.color->AddRGBPoint(255.0, 0.1, 0.2, 0.9);
  owned.SetRange(1.0, 255.0);
  return owned;
}
}

TEST_CASE("Curved colour and opacity functions are tables that follow the curve")
{
  for (const Curve& curve : Curves)
  {
    INFO(curve.name);
    OwnedFunctions owned{ { 1.0, 0.0 }, { 255.0, 0.5 } };
    curve.bend(SetUp(owned));
    const TransferFunctionTable table = owned.MakeTable();
    CHECK(table.Lookup == TransferFunctionLookup::Table);
    for (double scalar = 1.0; scalar < 255.0; scalar += 1.7)
    {
      const Matter found = LookUp(table, scalar, 1.0);
      const Matter expected = Evaluate(owned.functions, scalar);
      INFO("at " << scalar);
      // A table's tolerances.
      CHECK(found.extinction == Approx(expected.extinction).epsilon(0.007).margin(3e-4));
      for (int channel = 0; channel < 3; ++channel)
      {
        CHECK(found.color[channel] == Approx(expected.color[channel]).margin(0.006));
      }
    }
  }
}

TEST_CASE("A curved gray function gives all three channels")
{
  OwnedFunctions owned{ { 0.0, 0.1 } };
  vtkNew<vtkPiecewiseFunction> gray;
  gray->AddPoint(0.0, 0.25, 0.3, 0.5);
  gray->AddPoint(255.0, 0.75);
  owned.functions.Color = nullptr;
  owned.functions.Gray = gray;
  const TransferFunctionTable table = owned.MakeTable();
  for (double scalar = 0.0; scalar < 255.0; scalar += 1.7)
  {
    for (const double channel : LookUp(table, scalar, 1.0).color)
    {
      CHECK(channel == Approx(gray->GetValue(scalar)).margin(0.006));
    }
  }
}

TEST_CASE("A curved function with a step stays a table, as fine as allowed")
{
  for (const Curve& curve : Curves)
  {
    INFO(curve.name);
    OwnedFunctions owned{ { 1.0, 0.1 }, { 100.3, 0.1 }, { 100.3, 0.6 }, { 255.0, 0.6 } };
    curve.bend(SetUp(owned));
    const TransferFunctionTable table = owned.MakeTable();
    CHECK(table.Lookup == TransferFunctionLookup::Table);
    CHECK(table.GetSize() == 8192);
    // A cell is 0.031 wide.
    CHECK(LookUp(table, 100.26, 1.0).extinction ==
      Approx(Evaluate(owned.functions, 100.26).extinction).epsilon(0.005));
    CHECK(LookUp(table, 100.34, 1.0).extinction ==
      Approx(Evaluate(owned.functions, 100.34).extinction).epsilon(0.005));
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

TEST_CASE("Functions that are not clamped are nothing beyond their points")
{
  OwnedFunctions owned{ { 50.0, 0.5 }, { 100.0, 0.5 } };
  owned.opacity->ClampingOff();
  const TransferFunctionTable table = owned.MakeTable();
  CHECK(LookUp(table, 75.0, 1.0).extinction == Approx(ComputeExtinction(0.5, 1.0)));
  CHECK(LookUp(table, 20.0, 1.0).extinction == 0.0);
  CHECK(LookUp(table, 200.0, 1.0).extinction == 0.0);
}
