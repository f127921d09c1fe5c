#include "Catch.h"
#include "ReadDicom.h"

#include "vtkMatrix3x3.h"

#include <cmath>

namespace
{

// Slices of this orientation, 2.5 mm apart along their normal.
DicomSlices Turned(const Vector& row, const Vector& column)
{
  auto slices = Slices(5);
  for (int number = 0; number < 5; ++number)
  {
    SetOrientation(slices[number], row, column);
    const Vector normal = Normal(slices[number]);
    SetPosition(slices[number],
      { 120 + 2.5 * number * normal[0], -340 + 2.5 * number * normal[1],
        -1200 + 2.5 * number * normal[2] });
  }
  return slices;
}

void CheckTurned(const Vector& row, const Vector& column)
{
  const auto parser = GENERATE(from_range(Parsers()));
  const auto slices = Turned(row, column);
  const auto reading = ReadSlices(slices, parser);
  CHECK(reading.error == "");
  CHECK(reading.Warnings() == "");
  CHECK(Difference(reading.volume, slices) == "");
  CHECK(reading.volume->GetSpacing()[0] == Approx(0.75));
  CHECK(reading.volume->GetSpacing()[1] == Approx(0.5));
  CHECK(reading.volume->GetSpacing()[2] == Approx(2.5));
  CHECK(reading.volume->GetDirectionMatrix()->Determinant() == Approx(1.0));
}

}

TEST_CASE("Sagittal slices lie where they say")
{
  CheckTurned({ 0, 1, 0 }, { 0, 0, -1 });
}

TEST_CASE("Coronal slices lie where they say")
{
  CheckTurned({ 1, 0, 0 }, { 0, 0, -1 });
}

TEST_CASE("Oblique slices lie where they say")
{
  CheckTurned({ 0.8, 0.6, 0 }, { 0, 0, -1 });
}

TEST_CASE("Double oblique slices lie where they say")
{
  CheckTurned({ 2.0 / 3, -2.0 / 3, 1.0 / 3 }, { 2.0 / 3, 1.0 / 3, -2.0 / 3 });
}

TEST_CASE("Directions of few digits give a rotation")
{
  const auto slices = Turned({ 0.707, 0.707, 0 }, { -0.5, 0.5, 0.707 });
  const auto reading = ReadSlices(slices);
  REQUIRE(reading.error == "");
  CHECK(reading.volume->GetDimensions()[2] == 5);
  const auto matrix = reading.volume->GetDirectionMatrix();
  for (int a = 0; a < 3; ++a)
  {
    for (int b = 0; b < 3; ++b)
    {
      double product = 0.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        product += matrix->GetElement(axis, a) * matrix->GetElement(axis, b);
      }
      INFO("columns " << a << " and " << b);
      CHECK(std::abs(product - (a == b)) < 2e-3);
    }
  }
}

TEST_CASE("Each length of the sides of a pixel is kept")
{
  auto slices = Slices(3);
  for (auto& slice : slices)
  {
    slice.elements["PixelSpacing"] = "3\\0.125";
  }
  const auto reading = ReadSlices(slices);
  CHECK(reading.volume->GetSpacing()[0] == 0.125);
  CHECK(reading.volume->GetSpacing()[1] == 3.0);
  CHECK(Difference(reading.volume, slices) == "");
}
