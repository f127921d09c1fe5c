#include "Catch.h"
#include "TransferFunctionLookup.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace penumbra;

namespace
{
constexpr double Epsilon = std::numeric_limits<float>::epsilon();

// The depth of a unit distance within 0.5 % or 0.0002, or beyond 4, the colour within 0.004. A kink
// between the four positions of a cell that the table is checked at is up to 4/3 as wrong.
void CheckWithinTolerance(const OwnedFunctions& owned, const TransferFunctionTable& table)
{
  const TransferFunctions& functions = owned.functions;
  std::mt19937 generator(50);
  std::uniform_real_distribution<double> even(functions.DataLow, functions.DataHigh);
  std::normal_distribution<double> nearby(0.0, 0.001 * (functions.DataHigh - functions.DataLow));
  for (int sample = 0; sample < 2000; ++sample)
  {
    double node[4];
    functions.Opacity->GetNodeValue(sample / 2 % functions.Opacity->GetSize(), node);
    const double anywhere = sample % 2 == 0 ? even(generator) : node[0] + nearby(generator);
    const double scalar = std::clamp(anywhere, functions.DataLow, functions.DataHigh);
    const Matter found = LookUp(table, scalar, functions.UnitDistance);
    const Matter expected = Evaluate(functions, scalar);
    INFO("at " << scalar);
    const double depth = expected.extinction * functions.UnitDistance;
    const double error = std::abs(found.extinction * functions.UnitDistance - depth);
    CHECK((error <= 4.0 / 3.0 * (0.0002 + 0.005 * depth) ||
      std::min(found.extinction, expected.extinction) * functions.UnitDistance > 4.0));
    for (int channel = 0; channel < 3; ++channel)
    {
      CHECK(std::abs(found.color[channel] - expected.color[channel]) <= 4.0 / 3.0 * 0.004);
    }
  }
}

void CheckExact(const TransferFunctions& functions, const TransferFunctionTable& table,
  std::initializer_list<double> scalars)
{
  for (const double scalar : scalars)
  {
    INFO("at " << scalar);
    const Matter found = LookUp(table, scalar, functions.UnitDistance);
    const Matter expected = Evaluate(functions, scalar);
    CHECK(found.extinction == Approx(expected.extinction).epsilon(Epsilon).margin(1e-12));
    CHECK(found.color[1] == Approx(expected.color[1]).epsilon(Epsilon).margin(1e-12));
  }
}
}

TEST_CASE("A table of integer data is exact at every integer")
{
  OwnedFunctions owned{ { 0.0, 0.0 }, { 70.0, 0.125 }, { 71.0, 0.5 }, { 200.0, 0.25 } };
  owned.functions.IntegerData = true;
  owned.functions.UnitDistance = 2.5;
  const TransferFunctionTable table = owned.MakeTable();
  REQUIRE(table.Lookup == TransferFunctionLookup::Table);
  CHECK((table.GetSize() - 1) % 255 == 0);
  CheckExact(owned.functions, table, { 0.0, 1.0, 69.0, 70.0, 71.0, 72.0, 199.0, 200.0, 255.0 });
}

TEST_CASE("Ramps are within the tolerance at every scalar")
{
  OwnedFunctions gentle{ { 10.3, 0.0 }, { 200.7, 0.5 } };
  OwnedFunctions steep{ { 10.3, 0.0 }, { 20.7, 0.9 }, { 30.0, 1.0 }, { 200.0, 0.001 } };
  for (const double unitDistance : { 0.01, 1.0, 100.0 })
  {
    gentle.functions.UnitDistance = steep.functions.UnitDistance = unitDistance;
    const TransferFunctionTable table = gentle.MakeTable();
    CHECK(table.Lookup == TransferFunctionLookup::Table);
    CHECK(table.Color.size() == 3 * table.Extinction.size());
    CheckWithinTolerance(gentle, table);
    CheckWithinTolerance(steep, steep.MakeTable());
  }
}

TEST_CASE("A ramp that nears full opacity, and a narrow ramp of colour, keep the tolerance")
{
  OwnedFunctions dense{ { 0.0, 0.0 }, { 20.1, 0.98 }, { 255.0, 0.98 } };
  CheckWithinTolerance(dense, dense.MakeTable());
  OwnedFunctions colored{ { 0.0, 0.1 }, { 100.1, 0.1 }, { 102.1, 0.1 } };
  colored.color->AddRGBPoint(100.1, 0.0, 0.0, 0.0);
  colored.color->AddRGBPoint(102.1, 1.0, 1.0, 1.0);
  CheckWithinTolerance(colored, colored.MakeTable());
}

TEST_CASE("A gray function gives all three channels")
{
  OwnedFunctions owned{ { 0.0, 0.1 }, { 255.0, 0.6 } };
  vtkNew<vtkPiecewiseFunction> gray;
  gray->AddPoint(50.0, 0.25);
  gray->AddPoint(150.0, 0.75);
  owned.functions.Color = nullptr;
  owned.functions.Gray = gray;
  CheckWithinTolerance(owned, owned.MakeTable());
}

TEST_CASE("A function of one value is that value everywhere")
{
  for (const bool integerData : { false, true })
  {
    for (const double scalar : { -1e6, 0.0, 17.3, 300.0 })
    {
      OwnedFunctions owned{ { scalar, 0.3 } };
      owned.color->RemoveAllPoints();
      owned.color->AddRGBPoint(scalar, 0.25, 0.5, 0.75);
      owned.functions.IntegerData = integerData;
      CheckExact(owned.functions, owned.MakeTable(), { -1e6, 0.0, 17.3, 255.0, 1e6 });
    }
  }
}

TEST_CASE("Functions without points are transparent and white")
{
  OwnedFunctions owned{};
  owned.color->RemoveAllPoints();
  const Matter found = LookUp(owned.MakeTable(), 100.0, 1.0);
  CHECK(found.extinction == 0.0);
  CHECK(found.color == std::array<double, 3>{ 1.0, 1.0, 1.0 });
}

TEST_CASE("Only the part of the functions that the data reaches is tabulated")
{
  OwnedFunctions owned{ { -1e5, 0.0 }, { 1e5, 0.5 } };
  owned.SetRange(-3.0, 5.0);
  const TransferFunctionTable table = owned.MakeTable();
  CHECK(table.Low == -3.0);
  CHECK(table.High == 5.0);
  CheckWithinTolerance(owned, table);
  // Data beyond all points has the value of the last one.
  owned.SetRange(2e5, 3e5);
  CheckExact(owned.functions, owned.MakeTable(), { 2e5, 2.5e5, 3e5 });
}

TEST_CASE("Functions keep the values of their first and last points")
{
  OwnedFunctions owned{ { 100.0, 0.2 }, { 120.0, 0.6 } };
  const TransferFunctionTable table = owned.MakeTable();
  CHECK(LookUp(table, 0.0, 1.0).extinction == Approx(ComputeExtinction(0.2, 1.0)));
  CHECK(LookUp(table, 99.0, 1.0).extinction == Approx(ComputeExtinction(0.2, 1.0)));
  CHECK(LookUp(table, 121.0, 1.0).extinction == Approx(ComputeExtinction(0.6, 1.0)));
  CHECK(LookUp(table, 1e9, 1.0).extinction == Approx(ComputeExtinction(0.6, 1.0)));
  CHECK(LookUp(table, 1e9, 1.0).color[0] == Approx(1.0));
}
