#include "Catch.h"
#include "ReadDicom.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <cstring>
#include <fstream>
#include <iterator>

namespace
{

constexpr int PixelsPerSlice = 256 * 256;

// The pixels are the last element of each file: 16 bits, least significant byte first.
std::vector<short> PixelsOf(int number)
{
  const std::string digits = std::to_string(number);
  const std::string name = "/brain_" + std::string(3 - digits.size(), '0') + digits + ".dcm";
  std::ifstream file(PENUMBRA_DATA "/mr-brain" + name, std::ios::binary);
  const std::string bytes{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  std::vector<short> pixels(PixelsPerSlice);
  REQUIRE(bytes.size() > 2 * PixelsPerSlice);
  std::memcpy(pixels.data(), bytes.data() + bytes.size() - 2 * PixelsPerSlice, 2 * PixelsPerSlice);
  return pixels;
}

}

TEST_CASE("The oblique MR series that is shipped lies where its slices say")
{
  const auto reading = ReadDicom(PENUMBRA_DATA "/mr-brain", PENUMBRA_DICOM_PARSER);
  REQUIRE(reading.error == "");
  CHECK(reading.Warnings().empty());
  const auto volume = reading.volume;
  REQUIRE(volume->GetDimensions()[2] == 20);
  CHECK(volume->GetScalarType() == VTK_SHORT);
  // Image Position (Patient) of the last file's first pixel and, by its Image Orientation and Pixel
  // Spacing, of its last one. Positions are rounded to tenths of a millimetre.
  double place[3];
  volume->TransformIndexToPhysicalPoint(0, 0, 19, place);
  CHECK(place[0] == Approx(-110.5));
  CHECK(place[1] == Approx(-96.2063).margin(0.11));
  CHECK(place[2] == Approx(59.0425).margin(0.11));
  volume->TransformIndexToPhysicalPoint(255, 255, 19, place);
  CHECK(place[0] == Approx(-110.5 + 255 * 0.859375));
  CHECK(place[1] == Approx(-96.2063 + 255 * 0.859375 * 0.99096).margin(0.11));
  CHECK(place[2] == Approx(59.0425 + 255 * 0.859375 * 0.134158).margin(0.11));
  vtkDataArray* const values = volume->GetPointData()->GetScalars();
  int differences = 0;
  for (int slice = 0; slice < 20; ++slice)
  {
    const auto pixels = PixelsOf(slice + 1);
    for (int pixel = 0; pixel < PixelsPerSlice; ++pixel)
    {
      differences += values->GetTuple1(slice * PixelsPerSlice + pixel) != pixels[pixel] ? 1 : 0;
    }
  }
  CHECK(differences == 0);
}
