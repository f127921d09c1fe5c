#include "Catch.h"
#include "ReadDicom.h"

#include "vtkMatrix3x3.h"

#include <cmath>

namespace
{

// Slices that are shifted along their columns from one to the next.
DicomSlices Tilted(double degrees)
{
  auto slices = Slices(6);
  const double shift = 2.5 * std::tan(degrees * std::acos(-1.0) / 180);
  for (int number = 0; number < 6; ++number)
  {
    SetPosition(slices[number], { -10, 20 + shift * number, 30 + 2.5 * number });
  }
  return slices;
}

}

TEST_CASE("The slices of a tilted gantry stay where they are")
{
  const auto parser = GENERATE(from_range(Parsers()));
  const double degrees = GENERATE(15.0, -20.0, 3.0);
  const auto slices = Tilted(degrees);
  const auto reading = ReadSlices(slices, parser);
  CHECK(reading.error == "");
  CHECK(Difference(reading.volume, slices) == "");
  CHECK(Mentions(reading.Warnings(), "\\b" + std::to_string(int(std::abs(degrees))) + "\\b"));
  CHECK(Mentions(reading.Warnings(), "degree|\u00b0"));

  const auto matrix = reading.volume->GetDirectionMatrix();
  const double cosine = matrix->GetElement(1, 1) * matrix->GetElement(1, 2);
  CHECK(std::abs(cosine) > 0.04);
}

TEST_CASE("The tilt of oblique slices is measured from their own normal")
{
  auto slices = Slices(5);
  for (int number = 0; number < 5; ++number)
  {
    SetOrientation(slices[number], { 1, 0, 0 }, { 0, 0.8, 0.6 });
    SetPosition(slices[number], { 0, 0, 2.5 * number });
  }
  const auto reading = ReadSlices(slices);
  CHECK(Difference(reading.volume, slices) == "");
  // The angle whose cosine is 0.8.
  CHECK(Mentions(reading.Warnings(), "36\\.[89]|\\b37\\b"));
}

TEST_CASE("A tilted series with a missing slice keeps the others where they are")
{
  auto slices = Tilted(15);
  const auto whole = ReadSlices(slices).volume;
  REQUIRE(Difference(whole, slices) == "");
  slices.erase(slices.begin() + 2);
  const auto filled = ReadSlices(slices).volume;
  REQUIRE(filled->GetDimensions()[2] == 6);
  for (int k = 0; k < 6; ++k)
  {
    Vector expected;
    Vector place;
    whole->TransformIndexToPhysicalPoint(3, 2, k, expected.data());
    filled->TransformIndexToPhysicalPoint(3, 2, k, place.data());
    CHECK(
      std::hypot(place[0] - expected[0], place[1] - expected[1], place[2] - expected[2]) < 1e-4);
  }
}

TEST_CASE("Slices without a tilt are not said to have one")
{
  const auto slices = Tilted(0.0);
  const auto reading = ReadSlices(slices);
  CHECK(reading.Warnings() == "");
  CHECK(Difference(reading.volume, slices) == "");
}
