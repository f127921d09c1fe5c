#include "Catch.h"
#include "VisibleScalars.h"

using namespace penumbra;

namespace
{
// Entries at the scalars 0, 10, 20 and so on.
TransferFunctionTable MakeTable(const std::vector<float>& extinction)
{
  TransferFunctionTable table;
  table.Extinction = extinction;
  table.High = 10.0 * static_cast<double>(extinction.size() - 1);
  return table;
}
}

TEST_CASE("Between a visible entry and the next that is not, interpolation shows something")
{
  const VisibleScalars visible(MakeTable({ 0, 0, 1e-30f, 0, 0, 0, 3, 0 }));
  CHECK_FALSE(visible.AnyBetween(-100.0, 9.9));
  CHECK(visible.AnyBetween(-100.0, 10.1));
  CHECK(visible.AnyBetween(20.0, 20.0));
  CHECK(visible.AnyBetween(29.9, 45.0));
  CHECK_FALSE(visible.AnyBetween(30.1, 49.9));
  CHECK(visible.AnyBetween(30.1, 50.1));
  CHECK(visible.AnyBetween(0.0, 100.0));
  CHECK_FALSE(visible.AnyBetween(70.1, 1e9));
}

TEST_CASE("Beyond both ends of a table its first and last value hold on")
{
  const VisibleScalars visible(MakeTable({ 1, 0, 0, 0, 1 }));
  CHECK(visible.AnyBetween(-1e9, -1e8));
  CHECK(visible.AnyBetween(1e8, 1e9));
  CHECK_FALSE(visible.AnyBetween(15.0, 25.0));
}

TEST_CASE("Nothing is visible where all is transparent")
{
  CHECK_FALSE(VisibleScalars(MakeTable({ 0, 0, 0 })).AnyBetween(-1e9, 1e9));
  CHECK_FALSE(VisibleScalars().AnyBetween(-1e9, 1e9));
}

TEST_CASE("A steep table is visible wherever its integral grows")
{
  TransferFunctionTable table = MakeTable({ 0, 0, 0, 0 });
  table.Steep = true;
  table.ExtinctionIntegral = { 0, 0, 0.5f, 0.5f };
  const VisibleScalars visible(table);
  CHECK(visible.AnyBetween(11.0, 19.0));
  CHECK(visible.AnyBetween(1.0, 2.0));
  CHECK(visible.AnyBetween(21.0, 29.0));
  // Beyond its ends a table is as its ends are, and there is nothing.
  CHECK_FALSE(visible.AnyBetween(-10.0, -1.0));
  CHECK_FALSE(visible.AnyBetween(31.0, 40.0));
}

TEST_CASE("Points are visible up to their neighbours")
{
  TransferFunctionTable table = MakeTable({ 0, 0 });
  table.Lookup = TransferFunctionLookup::Points;
  table.Low = 100.0;
  table.PointScalars = { 0, 5, 5, 6 };
  table.PointColors = { 1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 0.5f, 1, 1, 1, 0 };
  const VisibleScalars visible(table);
  CHECK_FALSE(visible.AnyBetween(0.0, 104.9));
  CHECK(visible.AnyBetween(105.0, 105.0));
  CHECK(visible.AnyBetween(105.9, 200.0));
  CHECK_FALSE(visible.AnyBetween(106.1, 200.0));
}
