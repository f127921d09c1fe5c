#include "Catch.h"
#include "TransferFunctionLookup.h"

#include <cmath>
#include <limits>

using namespace penumbra;

namespace
{
// Opacities are floats, and so are scalars relative to the first point: within a ramp both are
// rounded.
constexpr double Rounding = 4.0 * std::numeric_limits<float>::epsilon();

void CheckOpacity(
  const OwnedFunctions& owned, const TransferFunctionTable& table, double scalar, double opacity)
{
  INFO("at " << scalar);
  const double unitDistance = owned.functions.UnitDistance;
  CHECK(LookUp(table, scalar, unitDistance).extinction ==
    Approx(ComputeExtinction(opacity, unitDistance)).epsilon(2.0 * Rounding).margin(1e-12));
}
}

TEST_CASE("A step is looked up among the points, exact on both sides")
{
  for (const bool integerData : { false, true })
  {
    OwnedFunctions owned{ { 0.0, 0.1 }, { 100.0, 0.1 }, { 100.0, 0.7 }, { 255.0, 0.3 } };
    owned.functions.IntegerData = integerData;
    owned.functions.UnitDistance = 3.0;
    const TransferFunctionTable table = owned.MakeTable();
    REQUIRE(table.Lookup == TransferFunctionLookup::Points);
    CheckOpacity(owned, table, 0.0, 0.1);
    CheckOpacity(owned, table, 99.999, 0.1);
    CheckOpacity(owned, table, 100.001, 0.7 - 0.4 * 0.001 / 155.0);
    CheckOpacity(owned, table, 177.5, 0.5);
    CheckOpacity(owned, table, 255.0, 0.3);
    // Colour has no step there, and points of its own.
    CHECK(LookUp(table, 100.0, 3.0).color[2] == Approx(100.0 / 255.0).epsilon(Rounding));
    CHECK(LookUp(table, 51.0, 3.0).color[2] == Approx(0.2).epsilon(Rounding));
  }
}

TEST_CASE("A step at the first or the last point is exact too")
{
  OwnedFunctions owned{ { 0.0, 0.0 }, { 0.0, 0.5 }, { 255.0, 0.5 }, { 255.0, 0.0 } };
  owned.SetRange(-10.0, 300.0);
  const TransferFunctionTable table = owned.MakeTable();
  CheckOpacity(owned, table, -1.0, 0.0);
  CheckOpacity(owned, table, 0.001, 0.5);
  CheckOpacity(owned, table, 254.999, 0.5);
  CheckOpacity(owned, table, 256.0, 0.0);
}

TEST_CASE("Beyond a step at the end of a table there is its outer side")
{
  const double before = GENERATE(0.0, 0.6);
  const double behind = 0.6 - before;
  const double colorAt = GENERATE(-50.0, 3.3, 50.0);
  OwnedFunctions owned{ { 3.3, before }, { 3.3, behind } };
  owned.color->RemoveAllPoints();
  owned.color->AddRGBPoint(colorAt, 1.0, 1.0, 1.0);
  owned.SetRange(-100.0, 100.0);
  const TransferFunctionTable table = owned.MakeTable();
  for (const double distance : { 1e-3, 1.0, 90.0 })
  {
    CheckOpacity(owned, table, 3.3 - distance, before);
    CheckOpacity(owned, table, 3.3 + distance, behind);
  }
  // Integrals go on by what the table itself has at its ends.
  CHECK(table.Extinction.front() == Approx(ComputeExtinction(before, 1.0)));
  CHECK(table.Extinction.back() == Approx(ComputeExtinction(behind, 1.0)));
}

TEST_CASE("A step of colour is looked up among the points")
{
  OwnedFunctions owned{ { 0.0, 0.1 }, { 255.0, 0.5 } };
  owned.color->RemoveAllPoints();
  owned.color->AddRGBPoint(0.0, 1.0, 0.0, 0.0);
  owned.color->AddRGBPoint(80.0, 1.0, 0.0, 0.0);
  owned.color->AddRGBPoint(80.0, 0.0, 0.0, 1.0);
  const TransferFunctionTable table = owned.MakeTable();
  REQUIRE(table.Lookup == TransferFunctionLookup::Points);
  CHECK(LookUp(table, 79.99, 1.0).color == std::array<double, 3>{ 1.0, 0.0, 0.0 });
  CHECK(LookUp(table, 80.01, 1.0).color == std::array<double, 3>{ 0.0, 0.0, 1.0 });
  CheckOpacity(owned, table, 51.0, 0.18);
}

TEST_CASE("A spike narrower than the cells of any table is looked up among the points")
{
  // Wherever it lies: between all the positions at which a table might be checked, too.
  for (const double place : { 12345.678, 500000.0, 654321.0, 999000.5 })
  {
    OwnedFunctions owned{ { 0.0, 0.0 }, { place - 1.0, 0.0 }, { place, 0.8 }, { place + 1.0, 0.0 },
      { 1e6, 0.0 } };
    owned.color->RemoveAllPoints();
    owned.color->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
    owned.SetRange(0.0, 1e6);
    const TransferFunctionTable table = owned.MakeTable();
    INFO("spike at " << place);
    CHECK(table.Lookup == TransferFunctionLookup::Points);
    const double depth = LookUp(table, place, 1.0).extinction;
    // The scalar is rounded to 1/16 at most, a sixteenth of the way down the spike.
    CHECK(depth == Approx(ComputeExtinction(0.8, 1.0)).epsilon(0.1));
  }
}

TEST_CASE("Narrow ramps keep their shape where one voxel has a huge value")
{
  for (const double opacity : { 0.5, 1.0 })
  {
    OwnedFunctions owned{ { 0.0, 0.0 }, { 255.0, opacity }, { 1e30, opacity } };
    owned.color->RemoveAllPoints();
    owned.color->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
    owned.SetRange(0.0, 1e30);
    const TransferFunctionTable table = owned.MakeTable();
    CheckOpacity(owned, table, 0.0, 0.0);
    CheckOpacity(owned, table, 51.0, 0.2 * opacity);
    CheckOpacity(owned, table, 204.0, 0.8 * opacity);
    CheckOpacity(owned, table, 1e30, opacity);
  }
}

TEST_CASE("A huge value beyond all points costs no accuracy")
{
  OwnedFunctions owned{ { 0.0, 0.0 }, { 255.0, 0.5 } };
  owned.SetRange(-1e30, 1e30);
  const TransferFunctionTable table = owned.MakeTable();
  CHECK(table.Lookup == TransferFunctionLookup::Table);
  CHECK((table.Low == 0.0 && table.High == 255.0));
  // A table's tolerance: half a percent.
  CHECK(LookUp(table, 51.0, 1.0).extinction == Approx(ComputeExtinction(0.1, 1.0)).epsilon(0.005));
  CHECK(LookUp(table, 1e30, 1.0).extinction == Approx(ComputeExtinction(0.5, 1.0)));
}

TEST_CASE("Points are exact far from 0")
{
  OwnedFunctions owned{ { 1e7, 0.1 }, { 1e7 + 2.0, 0.1 }, { 1e7 + 2.0, 0.9 }, { 1e7 + 4.0, 0.9 } };
  owned.color->RemoveAllPoints();
  owned.color->AddRGBPoint(1e7, 1.0, 1.0, 1.0);
  owned.SetRange(1e7, 1e7 + 4.0);
  const TransferFunctionTable table = owned.MakeTable();
  CheckOpacity(owned, table, 1e7 + 1.99, 0.1);
  CheckOpacity(owned, table, 1e7 + 2.01, 0.9);
}

// Single precision has to tell the points within the data apart.
TEST_CASE("Points far outside the data take no digits from those within")
{
  OwnedFunctions owned{ { -1e8, 0.0 }, { 0.5, 0.0 }, { 0.5, 0.8 }, { 1e8, 0.8 } };
  owned.SetRange(0.0, 1.0);
  const TransferFunctionTable table = owned.MakeTable();
  REQUIRE(table.Lookup == TransferFunctionLookup::Points);
  CHECK(table.Accurate);
  for (double scalar : table.PointScalars)
  {
    CHECK((scalar >= 0.0 && scalar <= 1.0));
  }
  CheckOpacity(owned, table, 0.4999, 0.0);
  CheckOpacity(owned, table, 0.5001, 0.8);
}

TEST_CASE("More points than a texture holds are told")
{
  OwnedFunctions owned{ { 0.0, 0.0 } };
  for (int i = 1; i < 20000; ++i)
  {
    owned.opacity->AddPoint(255.0 * i / 20000.0, i % 2 ? 0.9 : 0.1);
  }
  const TransferFunctionTable table = owned.MakeTable();
  CHECK_FALSE(table.Accurate);
  CHECK(table.Lookup == TransferFunctionLookup::Table);
  CHECK(table.GetSize() > 0);
}
