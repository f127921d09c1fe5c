#include "Catch.h"
#include "ReadDicom.h"

#include <algorithm>
#include <cmath>

namespace
{

// Slices whose z is in this list, rescaled so that their values are of a real type.
DicomSlices SlicesAt(const std::vector<double>& heights)
{
  auto slices = Slices(static_cast<int>(heights.size()));
  for (std::size_t number = 0; number < heights.size(); ++number)
  {
    SetPosition(slices[number], { -10, 20, heights[number] });
    slices[number].elements["RescaleSlope"] = "0.5";
    slices[number].elements["RescaleIntercept"] = "-7";
  }
  return slices;
}

double Interpolated(const DicomSlices& slices, int i, int j, double height)
{
  std::size_t above = 1;
  while (above + 1 < slices.size() && Position(slices[above])[2] < height)
  {
    ++above;
  }
  const double low = Position(slices[above - 1])[2];
  const double share = (height - low) / (Position(slices[above])[2] - low);
  const double stored =
    (1 - share) * slices[above - 1].stored(i, j, 0) + share * slices[above].stored(i, j, 0);
  return 0.5 * stored - 7;
}

// How far the volume is off the line between the slices that enclose each voxel.
double LargestError(vtkImageData* volume, const DicomSlices& slices)
{
  const int* const size = volume->GetDimensions();
  double error = 0.0;
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        Vector place;
        volume->TransformIndexToPhysicalPoint(i, j, k, place.data());
        const double expected = Interpolated(slices, i, j, place[2]);
        error =
          std::max(error, std::abs(volume->GetScalarComponentAsDouble(i, j, k, 0) - expected));
      }
    }
  }
  return error;
}

double Height(vtkImageData* volume, int k)
{
  Vector place;
  volume->TransformIndexToPhysicalPoint(0, 0, k, place.data());
  return place[2];
}

}

TEST_CASE("Missing slices are interpolated and told")
{
  const auto parser = GENERATE(from_range(Parsers()));
  // Without the heights 36, 42 and 44.
  const auto slices = SlicesAt({ 30, 32, 34, 38, 40, 46, 48, 50 });
  const auto reading = ReadSlices(slices, parser);
  REQUIRE(reading.error == "");
  CHECK(reading.volume->GetDimensions()[2] == 11);
  CHECK(reading.volume->GetSpacing()[2] == Approx(2.0));
  CHECK(Height(reading.volume, 0) == Approx(30));
  CHECK(LargestError(reading.volume, slices) < 1e-3);
  CHECK(Mentions(reading.Warnings(), "\\b3\\b"));
  CHECK(Mentions(reading.Warnings(), "missing|interpolat"));
}

TEST_CASE("Missing slices of whole numbers are interpolated to the nearest ones")
{
  auto slices = Slices(5);
  slices.erase(slices.begin() + 2);
  const auto reading = ReadSlices(slices);
  REQUIRE(reading.volume->GetDimensions()[2] == 5);
  CHECK(reading.volume->GetScalarType() == VTK_UNSIGNED_SHORT);
  for (int i = 0; i < 4; ++i)
  {
    // Of 100 i and 900 i; the present slices keep their values.
    CHECK(reading.volume->GetScalarComponentAsDouble(i, 1, 2, 0) == i + 10 + 500);
    CHECK(reading.volume->GetScalarComponentAsDouble(i, 1, 4, 0) == i + 10 + 1600);
  }
}

TEST_CASE("Interpolated whole numbers are rounded, below zero too")
{
  DicomSlices slices;
  for (const int number : { 0, 1, 3, 4 })
  {
    slices.push_back(Slice(number));
    slices.back().isSigned = true;
    slices.back().stored = [number](int i, int j, int)
    { return -100 + 7 * j + (number == 3 ? i : 0); };
  }
  const auto volume = ReadSlices(slices).volume;
  REQUIRE(volume->GetDimensions()[2] == 5);
  for (int i = 0; i < 4; ++i)
  {
    CHECK(std::abs(volume->GetScalarComponentAsDouble(i, 0, 2, 0) - (-100 + i / 2.0)) <= 0.5);
  }
}

TEST_CASE("Unevenly spaced slices are interpolated to even ones and told")
{
  const auto parser = GENERATE(from_range(Parsers()));
  const auto slices = SlicesAt({ 30, 31, 32, 33, 34.4, 37, 40.7, 44 });
  const auto reading = ReadSlices(slices, parser);
  REQUIRE(reading.error == "");
  REQUIRE(reading.volume->GetDimensions()[2] > 1);
  const double spacing = reading.volume->GetSpacing()[2];
  // Fine enough for the densest slices, and nothing lost at either end.
  CHECK(spacing < 1.5);
  CHECK(Height(reading.volume, 0) == Approx(30));
  const double last = Height(reading.volume, reading.volume->GetDimensions()[2] - 1);
  CHECK(last <= 44 + 1e-6);
  CHECK(last > 44 - spacing);
  CHECK(LargestError(reading.volume, slices) < 1e-2);
  CHECK(Mentions(reading.Warnings(), "[0-9]"));
  CHECK(Mentions(reading.Warnings(), "uneven|evenly|interpolat|resampl"));
}

TEST_CASE("A slice that is out of place by a quarter of the distance is told")
{
  const auto slices = SlicesAt({ 30, 32, 34.5, 36, 38, 40 });
  const auto reading = ReadSlices(slices);
  REQUIRE(reading.error == "");
  CHECK(Mentions(reading.Warnings(), "[0-9]"));
}

TEST_CASE("Missing slices of an oblique series leave the others where they are")
{
  auto slices = Slices(6);
  for (int number = 0; number < 6; ++number)
  {
    SetOrientation(slices[number], { 0.8, 0.6, 0 }, { 0, 0, -1 });
    const Vector normal = Normal(slices[number]);
    SetPosition(slices[number],
      { 1 + 2 * number * normal[0], 2 + 2 * number * normal[1], 3 + 2 * number * normal[2] });
  }
  const auto whole = ReadSlices(slices).volume;
  REQUIRE(Difference(whole, slices) == "");
  slices.erase(slices.begin() + 3);
  const auto filled = ReadSlices(slices).volume;
  REQUIRE(filled->GetDimensions()[2] == 6);
  for (int k : { 0, 2, 3, 5 })
  {
    Vector expected;
    Vector place;
    whole->TransformIndexToPhysicalPoint(3, 2, k, expected.data());
    filled->TransformIndexToPhysicalPoint(3, 2, k, place.data());
    CHECK(
      std::hypot(place[0] - expected[0], place[1] - expected[1], place[2] - expected[2]) < 1e-4);
    CHECK(filled->GetScalarComponentAsDouble(3, 2, k, 0) ==
      (k == 3 ? 23 + (400 + 1600) / 2 : 23 + 100 * k * k));
  }
}
