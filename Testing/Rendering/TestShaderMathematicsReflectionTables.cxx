#include "Catch.h"
#include "ModelAlbedo.h"
#include "ReflectionTables.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

TEST_CASE("The tables of ReflectionModels.md are what the shader computes")
{
  for (const AlbedoTable& expected : AlbedoTables())
  {
    const ReflectionTable table = ReadReflectionTable(expected.Heading);
    INFO("Table " << expected.Heading);
    CHECK(table.Angles == std::vector<double>({ 0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 85.0 }));
    CHECK(table.Rows.size() >= 2);
    for (const ReflectionRow& row : table.Rows)
    {
      REQUIRE(row.Values.size() == table.Angles.size());
      for (size_t column = 0; column < row.Values.size(); ++column)
      {
        const PrintedNumber printed = row.Values[column];
        INFO("Row " << row.Parameters[0] << ", " << table.Angles[column] << " degrees");
        // Rounding to the digits printed, and what another compiler's roundings may change.
        CHECK(printed.Value ==
          Approx(expected.Compute(row.Parameters, table.Angles[column], AlbedoPoints))
            .epsilon(0.0)
            .margin(0.5 * printed.Unit + 1e-5));
      }
    }
  }
}

TEST_CASE("The albedos in ReflectionModels.md have converged")
{
  for (const AlbedoTable& table : AlbedoTables())
  {
    for (const ReflectionRow& row : ReadReflectionTable(table.Heading).Rows)
    {
      for (const double angle : { 0.0, 60.0, 85.0 })
      {
        const double value = table.Compute(row.Parameters, angle, AlbedoPoints);
        const double coarser = table.Compute(row.Parameters, angle, AlbedoPoints * 2 / 5);
        INFO(table.Heading << " " << row.Parameters[0] << " at " << angle);
        CHECK(coarser == Approx(value).epsilon(0.0).margin(1e-3 * std::max(value, 1.0)));
      }
    }
  }
}
