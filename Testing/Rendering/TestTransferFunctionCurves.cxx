#include "Catch.h"
#include "TransferFunctionLookup.h"

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

TEST_CASE("Functions that are not clamped are nothing beyond their points")
{
  OwnedFunctions owned{ { 50.0, 0.5 }, { 100.0, 0.5 } };
  owned.opacity->ClampingOff();
  const TransferFunctionTable table = owned.MakeTable();
  CHECK(LookUp(table, 75.0, 1.0).extinction == Approx(ComputeExtinction(0.5, 1.0)));
  CHECK(LookUp(table, 20.0, 1.0).extinction == 0.0);
  CHECK(LookUp(table, 200.0, 1.0).extinction == 0.0);
}
