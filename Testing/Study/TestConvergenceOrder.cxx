#include "Catch.h"
#include "ConvergenceOrder.h"
#include "ErrorRows.h"

using namespace penumbra;

TEST_CASE("The observed order is that of the errors without the rounding to 8 bits")
{
  const auto observed = [](double order)
  { return ObservedOrder(RowsOfOrder(order, 0.2), "scene", "penumbra rays").value_or(0.0); };
  // With the rounding left in, they would be 1.97 and 1.45.
  CHECK(observed(2.0) == Approx(2.0).epsilon(0.002));
  CHECK(observed(1.5) == Approx(1.5).epsilon(0.002));
  // The finest error, from which the rounding is told, still has a part of its own here, a quarter
  // of a level, which makes the error before look smaller.
  CHECK(observed(1.0) == Approx(1.0).epsilon(0.03));
}

TEST_CASE("The order is that of the finest steps that tell one")
{
  std::vector<ErrorRow> rows = { Row("a", 4.0, 9.0, 1.0), Row("a", 2.0, 8.0, 1.0),
    Row("a", 1.0, 2.0, 1.0), Row("a", 0.5, 0.01, 1.0), Row("b", 0.5, 3.0, 1.0) };
  CHECK(*ObservedOrder(rows, "scene", "a") == Approx(2.0).epsilon(1e-4));
  CHECK_FALSE(OrderAt(rows, 0));
  CHECK(*OrderAt(rows, 1) == Approx(std::log2(9.0 / 8.0)).epsilon(1e-4));
  CHECK_FALSE(OrderAt(rows, 4));
  CHECK_FALSE(ObservedOrder(rows, "scene", "b"));
  CHECK_FALSE(ObservedOrder(rows, "another", "a"));
}

TEST_CASE("A grid that ends before rounding is reached has its order all the same")
{
  auto rows = RowsOfOrder(1.0, 0.2);
  rows.resize(3);
  CHECK(*ObservedOrder(rows, "scene", "penumbra rays") == Approx(1.0).epsilon(0.01));
}

TEST_CASE("Errors close to the rounding tell no order")
{
  const std::vector<ErrorRow> rows = { Row("a", 4.0, 0.5, 1.0), Row("a", 2.0, 0.3, 1.0),
    Row("a", 1.0, 0.26, 1.0), Row("a", 0.5, 0.26, 1.0) };
  CHECK_FALSE(ObservedOrder(rows, "scene", "a"));
}
