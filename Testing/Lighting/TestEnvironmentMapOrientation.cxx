#include "Catch.h"
#include "EnvironmentSamples.h"

#include <algorithm>
#include <cmath>
#include <string>

using namespace penumbra;

namespace
{
constexpr double Power = 100.0;

struct Pixel
{
  int column;
  int row;
};

/// White pixels on black; rows from the top.
vtkSmartPointer<vtkImageData> MakeSpots(int width, int height, const std::vector<Pixel>& pixels)
{
  std::vector<double> values(static_cast<std::size_t>(width) * height, 0.0);
  for (const Pixel& pixel : pixels)
  {
    values[static_cast<std::size_t>(pixel.row) * width + pixel.column] = 1.0;
  }
  return MakeImage(width, height, values);
}

/// Where the light of a cube map is, as a sum over its texels.
Direction FindLight(const CubeMap& cube)
{
  Direction sum{};
  for (int face = 0; face < 6; ++face)
  {
    for (int row = 0; row < cube.Size; ++row)
    {
      for (int column = 0; column < cube.Size; ++column)
      {
        const double s = (column + 0.5) / cube.Size;
        const double t = (row + 0.5) / cube.Size;
        const Direction w = GetDirection({ face, s, t });
        const double value = cube.Faces[face][(row * cube.Size + column) * 3];
        // A texel's solid angle goes with the cube of its direction's largest component.
        const double largest = std::max({ std::abs(w[0]), std::abs(w[1]), std::abs(w[2]) });
        for (int k = 0; k < 3; ++k)
        {
          sum[k] += value * largest * largest * largest * w[k];
        }
      }
    }
  }
  return Normalize(sum);
}

void CheckLight(const std::vector<vtkImageData*>& images, const Direction& expected)
{
  std::string reason;
  const EnvironmentMap map = MakeEnvironmentMap(images, reason).value();
  const Direction direction = Normalize(expected);
  const CubeMap glossy = FilterSpecular(map, Power);
  const double degree = 3.14159265358979 / 180.0;
  CAPTURE(expected, FindLight(glossy));
  CHECK(Dot(FindLight(glossy), direction) > std::cos(0.5 * degree));
  CHECK(Dot(FindLight(FilterDiffuse(map)), direction) > std::cos(0.5 * degree));
  CHECK(Sample(glossy, direction) > 0.0);
  CHECK(
    Sample(glossy, { -direction[0], -direction[1], -direction[2] }) == Approx(0.0).margin(1e-4));
}

void CheckEquirectangular(const std::vector<Pixel>& pixels, const Direction& expected)
{
  const auto image = MakeSpots(64, 32, pixels);
  CheckLight({ image }, expected);
}

void CheckFace(int face, const std::vector<Pixel>& pixels, const Direction& expected)
{
  const auto black = MakeSpots(20, 20, {});
  const auto bright = MakeSpots(20, 20, pixels);
  std::vector<vtkImageData*> images(6, black);
  images[face] = bright;
  CheckLight(images, expected);
}
}

TEST_CASE("An equirectangular image has each axis where VTK has it")
{
  CheckEquirectangular({ { 31, 15 }, { 32, 15 }, { 31, 16 }, { 32, 16 } }, { 1.0, 0.0, 0.0 });
  CheckEquirectangular({ { 0, 15 }, { 63, 15 }, { 0, 16 }, { 63, 16 } }, { -1.0, 0.0, 0.0 });
  CheckEquirectangular({ { 47, 15 }, { 48, 15 }, { 47, 16 }, { 48, 16 } }, { 0.0, 0.0, 1.0 });
  CheckEquirectangular({ { 15, 15 }, { 16, 15 }, { 15, 16 }, { 16, 16 } }, { 0.0, 0.0, -1.0 });
  std::vector<Pixel> top;
  std::vector<Pixel> bottom;
  for (int column = 0; column < 64; ++column)
  {
    top.push_back({ column, 0 });
    bottom.push_back({ column, 31 });
  }
  CheckEquirectangular(top, { 0.0, 1.0, 0.0 });
  CheckEquirectangular(bottom, { 0.0, -1.0, 0.0 });
}

TEST_CASE("Right of an equirectangular image's centre is +z, and above it +y")
{
  // 4.5 columns of 5.625 degrees to the right, 3.5 rows of as many up.
  CheckEquirectangular({ { 36, 12 } }, { 0.8512, 0.3369, 0.4024 });
  CheckEquirectangular({ { 27, 12 } }, { 0.8512, 0.3369, -0.4024 });
  CheckEquirectangular({ { 36, 19 } }, { 0.8512, -0.3369, 0.4024 });
  CheckEquirectangular({ { 52, 19 } }, { -0.4024, -0.3369, 0.8512 });
}

TEST_CASE("Each of six images has its axis in the middle")
{
  const std::vector<Pixel> middle = { { 9, 9 }, { 10, 9 }, { 9, 10 }, { 10, 10 } };
  CheckFace(0, middle, { 1.0, 0.0, 0.0 });
  CheckFace(1, middle, { -1.0, 0.0, 0.0 });
  CheckFace(2, middle, { 0.0, 1.0, 0.0 });
  CheckFace(3, middle, { 0.0, -1.0, 0.0 });
  CheckFace(4, middle, { 0.0, 0.0, 1.0 });
  CheckFace(5, middle, { 0.0, 0.0, -1.0 });
}

TEST_CASE("Six images lie as OpenGL's faces do")
{
  // 4.5 columns of a tenth to the left of the middle, 2.5 rows of as much above it.
  const std::vector<Pixel> leftAbove = { { 5, 7 } };
  CheckFace(0, leftAbove, { 1.0, 0.25, 0.45 });
  CheckFace(1, leftAbove, { -1.0, 0.25, -0.45 });
  CheckFace(2, leftAbove, { -0.45, 1.0, -0.25 });
  CheckFace(3, leftAbove, { -0.45, -1.0, 0.25 });
  CheckFace(4, leftAbove, { -0.45, 0.25, 1.0 });
  CheckFace(5, leftAbove, { 0.45, 0.25, -1.0 });
}

TEST_CASE("Both forms of one environment give the same")
{
  const Environment uneven = [](const Direction& w)
  { return 0.4 + 0.3 * w[0] * w[1] + 0.2 * w[2] + 0.1 * std::sin(3.0 * w[1] - 2.0 * w[0]); };
  const EnvironmentMap one = MakeEquirectangular(512, 256, uneven).MakeMap();
  const EnvironmentMap six = MakeCubeFaces(128, uneven).MakeMap();
  for (const double power : { 0.0, 1.0, 30.0, 1000.0 })
  {
    const CubeMap fromOne = FilterSpecular(one, power);
    const CubeMap fromSix = FilterSpecular(six, power);
    REQUIRE(fromOne.Size == fromSix.Size);
    for (int face = 0; face < 6; ++face)
    {
      double worst = 0.0;
      for (std::size_t i = 0; i < fromOne.Faces[face].size(); ++i)
      {
        const double difference = fromOne.Faces[face][i] - fromSix.Faces[face][i];
        worst = std::max(worst, std::abs(difference));
      }
      CAPTURE(power, face);
      CHECK(worst < 1e-3);
    }
  }
}
