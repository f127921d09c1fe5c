#include "Catch.h"
#include "TransferFunctionLookup.h"
#include "VisibleScalars.h"

#include <cmath>

using namespace penumbra;

namespace
{
// Opaque matter of a narrow range of scalars, as wide as `width`, in data of 0 to 255.
TransferFunctionTable TableOfPeak(double width)
{
  OwnedFunctions owned{ { 0.0, 0.0 }, { 100.0, 0.0 }, { 100.0 + 0.5 * width, 0.6 },
    { 100.0 + width, 0.0 }, { 255.0, 0.0 } };
  owned.functions.DataHigh = 255.0;
  owned.functions.IntegerData = true;
  return MakeTransferFunctionTable(owned.functions, 8192);
}
}

TEST_CASE("Integrals over a constant function are its value times what they are taken over")
{
  OwnedFunctions owned{ { 0.0, 0.5 }, { 255.0, 0.5 } };
  owned.functions.DataHigh = 255.0;
  const auto table = MakeTransferFunctionTable(owned.functions, 8192);
  const std::size_t last = table.Extinction.size() - 1;
  const double cell = 1.0 / static_cast<double>(table.Extinction.size());
  const double length = static_cast<double>(last) * cell;
  const double extinction = table.Extinction[0];
  CHECK(table.ExtinctionIntegral.size() == table.Extinction.size());
  CHECK(table.ColorIntegral.size() == 3 * table.Extinction.size());
  CHECK(table.ExtinctionIntegral[0] == 0.0f);
  CHECK(table.ExtinctionIntegral[last] == Approx(extinction * length));
  // From black to white, colours are gray on average.
  CHECK(table.ColorIntegral[3 * last] == Approx(extinction * 0.5 * length));
}

TEST_CASE("Integrals of colour are weighted by the extinction")
{
  OwnedFunctions owned{ { 0.0, 0.2 }, { 255.0, 0.8 } };
  owned.functions.DataHigh = 255.0;
  const auto table = MakeTransferFunctionTable(owned.functions, 8192);
  const std::size_t last = table.Extinction.size() - 1;
  double sum = 0.0;
  for (std::size_t entry = 0; entry < last; ++entry)
  {
    sum += 0.5 *
      (table.Extinction[entry] * table.Color[3 * entry + 1] +
        table.Extinction[entry + 1] * table.Color[3 * entry + 4]);
  }
  // The trapezoid rule is off by the product of the differences over a cell.
  CHECK(table.ColorIntegral[3 * last + 1] * static_cast<double>(table.Extinction.size()) ==
    Approx(sum).epsilon(1e-5));
}

TEST_CASE("Narrow peaks are steep, wide ramps are not")
{
  CHECK(TableOfPeak(2.0).Steep);
  CHECK(TableOfPeak(8.0).Steep);
  CHECK_FALSE(TableOfPeak(100.0).Steep);
  OwnedFunctions ramp{ { 40.0, 0.0 }, { 110.0, 0.25 }, { 255.0, 0.6 } };
  ramp.functions.DataHigh = 255.0;
  CHECK_FALSE(MakeTransferFunctionTable(ramp.functions, 8192).Steep);
}

TEST_CASE("A step that ends a table is steep, a constant is not")
{
  const double before = GENERATE(0.0, 0.6);
  const double behind = GENERATE(0.0, 0.6);
  OwnedFunctions owned{ { 100.0, before }, { 100.0, behind } };
  owned.color->RemoveAllPoints();
  owned.color->AddRGBPoint(100.0, 1.0, 1.0, 1.0);
  CHECK(owned.MakeTable().Steep == (before != behind));
}

TEST_CASE("What hardly shows is not steep")
{
  OwnedFunctions faint{ { 0.0, 0.0 }, { 100.0, 0.0 }, { 101.0, 0.01 }, { 102.0, 0.0 },
    { 255.0, 0.0 } };
  faint.functions.DataHigh = 255.0;
  CHECK_FALSE(MakeTransferFunctionTable(faint.functions, 8192).Steep);
}

TEST_CASE("Integrals are over the range of their table where points are looked up beside it")
{
  OwnedFunctions owned{ { 38.0, 0.0 }, { 48.7, 0.005 }, { 52.5, 0.75 } };
  owned.color->RemoveAllPoints();
  owned.color->AddRGBPoint(40.0, 1.0, 1.0, 1.0);
  owned.functions.IntegerData = true;
  const TransferFunctionTable table = owned.MakeTable();
  REQUIRE(table.Lookup == TransferFunctionLookup::Points);
  REQUIRE(table.Steep);
  CHECK(table.Low == 38.0);
  CHECK(table.High == 53.0);
  // The integral grows over the last half value by the extinction there.
  const double last = table.GetSize() - 1.0;
  const auto halfValueBefore = static_cast<std::size_t>(std::lround(last * (1.0 - 0.5 / 15.0)));
  const double cells = last - static_cast<double>(halfValueBefore);
  CHECK((table.ExtinctionIntegral.back() - table.ExtinctionIntegral[halfValueBefore]) *
      table.GetSize() / cells ==
    Approx(ComputeExtinction(0.75, 1.0)).epsilon(1e-3));
  // What is in that range is visible, and what is before it is not.
  const VisibleScalars visible(table);
  CHECK(visible.AnyBetween(50.0, 51.0));
  CHECK(visible.AnyBetween(100.0, 255.0));
  CHECK_FALSE(visible.AnyBetween(0.0, 37.9));
  // Points are told from the same scalar.
  CHECK(LookUp(table, 52.5, 1.0).extinction == Approx(ComputeExtinction(0.75, 1.0)));
  CHECK(LookUp(table, 0.0, 1.0).extinction == 0.0);
}
