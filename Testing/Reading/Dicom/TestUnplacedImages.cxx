#include "Catch.h"
#include "ReadDicom.h"

#include "vtkMatrix3x3.h"

namespace
{

// Images that do not say where they are, in another order than that of their numbers.
DicomSlices Unplaced()
{
  DicomSlices slices;
  for (const int number : { 10, 2, 9, 1 })
  {
    auto slice = Slice(number);
    slice.elements.erase("ImagePositionPatient");
    slice.elements.erase("ImageOrientationPatient");
    slices.push_back(slice);
  }
  return slices;
}

void CheckVolume(const DicomSlices& slices, double distance)
{
  const auto parser = GENERATE(from_range(Parsers()));
  const auto reading = ReadSlices(slices, parser);
  REQUIRE(reading.error == "");
  REQUIRE(reading.volume->GetDimensions()[2] == 4);
  CHECK(reading.volume->GetSpacing()[0] == 0.75);
  CHECK(reading.volume->GetSpacing()[1] == 0.5);
  CHECK(reading.volume->GetSpacing()[2] == distance);
  CHECK(reading.volume->GetDirectionMatrix()->Determinant() == Approx(1.0));
  CHECK(Mentions(reading.Warnings(), "position"));
  const int numbers[4] = { 1, 2, 9, 10 };
  for (int k = 0; k < 4; ++k)
  {
    CHECK(
      reading.volume->GetScalarComponentAsDouble(3, 2, k, 0) == Slice(numbers[k]).stored(3, 2, 0));
  }
}

}

TEST_CASE("Images without positions are ordered by their numbers and apart by their spacing")
{
  auto slices = Unplaced();
  for (auto& slice : slices)
  {
    slice.elements["SpacingBetweenSlices"] = "3.5";
  }
  CheckVolume(slices, 3.5);
}

TEST_CASE("Images without positions and spacing are apart by their thickness")
{
  CheckVolume(Unplaced(), 2.0);
}

TEST_CASE("Images without any geometry have a spacing of 1")
{
  auto slices = Unplaced();
  for (auto& slice : slices)
  {
    slice.elements.erase("PixelSpacing");
    slice.elements.erase("SliceThickness");
  }
  const auto reading = ReadSlices(slices);
  REQUIRE(reading.error == "");
  for (int axis = 0; axis < 3; ++axis)
  {
    CHECK(reading.volume->GetSpacing()[axis] == 1.0);
  }
  CHECK(Mentions(reading.Warnings(), "spacing"));
}

TEST_CASE("One image without a position among others is left out and told")
{
  auto slices = Slices(4);
  auto other = Slice(9);
  other.elements.erase("ImagePositionPatient");
  auto all = slices;
  all.insert(all.begin(), other);
  const auto reading = ReadSlices(all);
  CHECK(reading.error == "");
  CHECK(Difference(reading.volume, slices) == "");
  CHECK(Mentions(reading.Warnings(), "\\b1\\b.*left out"));
}

TEST_CASE("An orientation is kept where there are no positions")
{
  auto slices = Unplaced();
  for (auto& slice : slices)
  {
    SetOrientation(slice, { 0, 1, 0 }, { 0, 0, -1 });
  }
  const auto reading = ReadSlices(slices);
  REQUIRE(reading.error == "");
  const auto matrix = reading.volume->GetDirectionMatrix();
  CHECK(matrix->GetElement(1, 0) == Approx(1.0));
  CHECK(matrix->GetElement(2, 1) == Approx(-1.0));
  CHECK(matrix->GetElement(0, 2) == Approx(-1.0));
}

TEST_CASE("Projection images have the pixel spacing of their detector")
{
  auto image = Slice(0);
  image.elements.erase("PixelSpacing");
  image.elements.erase("ImagePositionPatient");
  image.elements.erase("ImageOrientationPatient");
  image.elements["ImagerPixelSpacing"] = "0.125\\0.25";
  const auto reading = ReadSlices({ image });
  REQUIRE(reading.error == "");
  CHECK(reading.volume->GetSpacing()[0] == 0.25);
  CHECK(reading.volume->GetSpacing()[1] == 0.125);
}
