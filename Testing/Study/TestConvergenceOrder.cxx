#include "Catch.h"
#include "ConvergenceOrder.h"
#include "ErrorRows.h"

using namespace penumbra;

TEST_CASE("The observed order is that of the errors without the rounding to 8 bits")
{
  for (const double order : { 1.0, 1.5, 2.0 })
  {
    const auto observed = ObservedOrder(RowsOfOrder(order, 0.2), "scene", "penumbra rays");
    REQUIRE(observed);
    // The finest error, from which the rounding is told, has a part of its own: of order 1 a
    // quarter of a level, and of the finest steps that count, 1/2 and 1/4, it takes 4 %.
    CHECK(*observed == Approx(order).epsilon(0.04));
  }
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
