#include "Catch.h"
#include "StructuralSimilarity.h"

#include <vtkMath.h>

#include <cmath>
#include <functional>

using namespace penumbra;

namespace
{
GreyPicture MakeGrey(int width, int height, const std::function<double(int, int)>& level)
{
  GreyPicture picture{ width, height, {} };
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      picture.levels.push_back(level(x, y));
    }
  }
  return picture;
}

double Waves(int x, int y)
{
  return 128 + 80 * std::sin(0.3 * x) * std::cos(0.23 * y);
}
}

TEST_CASE("A picture is entirely similar to itself, whatever its size")
{
  const int width = GENERATE(1, 4, 11, 70);
  const int height = GENERATE(1, 9, 40);
  const GreyPicture picture = MakeGrey(width, height, Waves);
  CHECK(StructuralSimilarity(picture, picture) == Approx(1.0).margin(1e-12));
}

TEST_CASE("Flat pictures differ by their means alone")
{
  const GreyPicture a = MakeGrey(30, 20, [](int, int) { return 100; });
  const GreyPicture b = MakeGrey(30, 20, [](int, int) { return 140; });
  const double c1 = 2.55 * 2.55;
  const double expected = (2 * 100.0 * 140.0 + c1) / (100.0 * 100.0 + 140.0 * 140.0 + c1);
  CHECK(StructuralSimilarity(a, b) == Approx(expected));
}

TEST_CASE("The window is Gaussian, cut off at the border and renormalised")
{
  const GreyPicture a = MakeGrey(30, 20, Waves);
  const GreyPicture b = MakeGrey(30, 20,
    [](int x, int y) { return 128 + 60 * std::sin(0.3 * (x + 1)) * std::cos(0.2 * y) + 0.5 * x; });
  // From SciPy's convolutions; away from the border they agree with scikit-image's
  // structural_similarity(gaussian_weights=True, sigma=1.5, use_sample_covariance=False).
  CHECK(StructuralSimilarity(a, b) == Approx(0.8362205203172072).epsilon(1e-12));
}

TEST_CASE("Contrast reversed about the mean is dissimilar")
{
  const GreyPicture board =
    MakeGrey(40, 40, [](int x, int y) { return (x + y) % 2 ? 228.0 : 28.0; });
  const GreyPicture reversed =
    MakeGrey(40, 40, [](int x, int y) { return (x + y) % 2 ? 28.0 : 228.0; });
  CHECK(StructuralSimilarity(board, reversed) < -0.9);
}

TEST_CASE("A growing shift lowers the similarity")
{
  const GreyPicture waves = MakeGrey(64, 64, Waves);
  double previous = 1.0;
  for (int shift = 1; shift <= 5; ++shift)
  {
    const GreyPicture shifted = MakeGrey(64, 64, [=](int x, int y) { return Waves(x + shift, y); });
    const double similarity = StructuralSimilarity(waves, shifted);
    CHECK(similarity < previous - 0.01);
    previous = similarity;
  }
}

TEST_CASE("Noise costs more similarity than an offset of the same RMSE")
{
  vtkMath::RandomSeed(20);
  const GreyPicture waves = MakeGrey(64, 64, Waves);
  const GreyPicture offset = MakeGrey(64, 64, [](int x, int y) { return Waves(x, y) + 20; });
  const GreyPicture noisy =
    MakeGrey(64, 64, [](int x, int y) { return Waves(x, y) + vtkMath::Gaussian(0, 20); });
  CHECK(StructuralSimilarity(waves, offset) > 0.9);
  CHECK(StructuralSimilarity(waves, noisy) < 0.8);
}
