#include "Catch.h"
#include "ImageComparison.h"
#include "TestPictures.h"

#include <vtkMath.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

using namespace penumbra;

namespace
{
/// Folders of one test alone (ctest runs several at a time), gone at its end.
struct TemporaryFolders
{
  TemporaryFolders() { std::filesystem::create_directories(this->folders.baselines); }
  ~TemporaryFolders() { std::filesystem::remove_all(this->root); }

  bool HasFailure(const std::string& file) const
  {
    return std::filesystem::exists(this->folders.failures + "/" + file);
  }

  const std::filesystem::path root = std::filesystem::temp_directory_path() /
    ("penumbra comparison " + std::to_string(std::random_device{}()));
  const BaselineFolders folders = { (root / "baselines").string(), (root / "failures").string() };
};

constexpr ComparisonThresholds tight = { 0.5, 0.999 };
}

TEST_CASE("Equal pictures do not differ")
{
  const ImageDifference difference = CompareImages(MakeDisc(), MakeDisc());
  CHECK(difference.rmse == 0.0);
  CHECK(difference.largest == 0.0);
  CHECK(difference.ssim == 1.0);
}

TEST_CASE("The difference of every channel counts in RMSE and largest difference")
{
  const int channels = GENERATE(3, 4);
  const auto grey = MakePicture(20, 10, channels, [](int, int, int) { return 100; });

  SECTION("a constant offset is the RMSE")
  {
    const auto brighter = MakePicture(20, 10, channels, [](int, int, int) { return 107; });
    const ImageDifference difference = CompareImages(grey, brighter);
    CHECK(difference.rmse == Approx(7.0));
    CHECK(difference.largest == 7.0);
  }
  SECTION("one channel of one pixel")
  {
    const auto dot = MakePicture(20, 10, channels,
      [=](int x, int y, int channel)
      { return x == 3 && y == 4 && channel == channels - 1 ? 60 : 100; });
    const ImageDifference difference = CompareImages(grey, dot);
    CHECK(difference.rmse == Approx(40.0 / std::sqrt(20.0 * 10.0 * channels)));
    CHECK(difference.largest == 40.0);
  }
}

TEST_CASE("Gaussian noise has its standard deviation as RMSE")
{
  vtkMath::RandomSeed(20);
  const auto grey = MakePicture(128, 128, 3, [](int, int, int) { return 128; });
  const auto noisy =
    MakePicture(128, 128, 3, [](int, int, int) { return vtkMath::Gaussian(128.0, 10.0); });
  CHECK(CompareImages(grey, noisy).rmse == Approx(10.0).epsilon(0.02));
}

TEST_CASE("Similarity is that of the luminances")
{
  const int channel = GENERATE(0, 1, 2);
  const double weights[] = { 0.299, 0.587, 0.114 };
  const auto black = MakeBlank(20, 20);
  const auto tinted =
    MakePicture(20, 20, 3, [=](int, int, int c) { return c == channel ? 100 : 0; });
  const double luminance = 100 * weights[channel];
  const double c1 = 2.55 * 2.55;
  CHECK(CompareImages(black, tinted).ssim == Approx(c1 / (luminance * luminance + c1)));
}

TEST_CASE("Pictures that cannot be compared are refused")
{
  CHECK_THROWS_AS(CompareImages(MakeBlank(64, 48), MakeBlank(48, 64)), std::invalid_argument);
  CHECK_THROWS_AS(CompareImages(MakeBlank(9, 9, 3), MakeBlank(9, 9, 4)), std::invalid_argument);
  CHECK_THROWS_AS(CompareImages(MakeBlank(9, 9, 1), MakeBlank(9, 9, 1)), std::invalid_argument);
  CHECK_THROWS_AS(CompareImages(MakeBlank(0, 0), MakeBlank(0, 0)), std::invalid_argument);
}

TEST_CASE("The difference image is stretched to its largest difference")
{
  const auto a = MakePicture(2, 1, 4, [](int x, int, int) { return 100 + 4 * x; });
  const auto b = MakePicture(2, 1, 4, [](int x, int, int channel) { return 100 - channel * x; });
  const auto difference = DifferenceImage(a, b);
  REQUIRE(difference->GetNumberOfScalarComponents() == 3);
  const auto* levels = static_cast<unsigned char*>(difference->GetScalarPointer());
  // The alpha channel differs most, by 7.
  const int expected[] = { 0, 0, 0, 146, 182, 219 };
  for (int i = 0; i < 6; ++i)
  {
    CHECK(static_cast<int>(levels[i]) == expected[i]);
  }
}

TEST_CASE("A picture survives a PNG file")
{
  const TemporaryFolders temporary;
  const auto picture = MakePicture(
    7, 5, GENERATE(3, 4), [](int x, int y, int channel) { return 30 * x + 8 * y + channel; });
  const std::string file = (temporary.root / "picture.png").string();
  WritePNG(picture, file);
  CHECK(CompareImages(picture, ReadPNG(file)).largest == 0.0);
}

TEST_CASE("PNG files that cannot be read or written are named")
{
  const TemporaryFolders temporary;
  const std::string text = (temporary.root / "text.png").string();
  std::ofstream(text) << "not a picture";
  CHECK_THROWS_WITH(ReadPNG(text), Catch::Matchers::ContainsSubstring(text));
  const std::string nowhere = (temporary.root / "none" / "picture.png").string();
  CHECK_THROWS_WITH(ReadPNG(nowhere), Catch::Matchers::ContainsSubstring(nowhere));
  CHECK_THROWS_WITH(WritePNG(MakeDisc(), nowhere), Catch::Matchers::ContainsSubstring(nowhere));
}

TEST_CASE("A picture that equals its baseline passes and leaves nothing")
{
  const TemporaryFolders temporary;
  WritePNG(MakeDisc(), temporary.folders.baselines + "/Disc.png");
  CHECK(CompareWithBaseline(MakeDisc(), "Disc", tight, temporary.folders));
  CHECK_FALSE(std::filesystem::exists(temporary.folders.failures));
}

TEST_CASE("A picture that differs from its baseline fails and leaves picture and difference")
{
  const TemporaryFolders temporary;
  WritePNG(MakeDisc(), temporary.folders.baselines + "/Disc.png");
  const auto wrong = GENERATE(as<bool>(), true, false) ? MakeBlank() : MakeDisc(2);
  REQUIRE_FALSE(CompareWithBaseline(wrong, "Disc", tight, temporary.folders));
  CHECK(CompareImages(ReadPNG(temporary.folders.failures + "/Disc.png"), wrong).largest == 0.0);
  CHECK(temporary.HasFailure("Disc-difference.png"));
}

TEST_CASE("Either threshold alone fails a picture")
{
  const TemporaryFolders temporary;
  WritePNG(MakeDisc(), temporary.folders.baselines + "/Disc.png");
  const auto shifted = MakeDisc(1);
  const ImageDifference difference = CompareImages(shifted, MakeDisc());
  const auto passes = [&](double maxRmse, double minSsim) {
    return CompareWithBaseline(shifted, "Disc", { maxRmse, minSsim }, temporary.folders);
  };
  CHECK(passes(difference.rmse, difference.ssim));
  CHECK_FALSE(passes(difference.rmse * 0.99, 0.0));
  CHECK_FALSE(passes(255.0, difference.ssim + 0.001));
}

TEST_CASE("A missing baseline fails and leaves the picture")
{
  const TemporaryFolders temporary;
  CHECK_FALSE(CompareWithBaseline(MakeDisc(), "Disc", { 255.0, 0.0 }, temporary.folders));
  CHECK(temporary.HasFailure("Disc.png"));
  CHECK_FALSE(temporary.HasFailure("Disc-difference.png"));
}

TEST_CASE("A baseline of another size, or none at all, fails and leaves the picture")
{
  const TemporaryFolders temporary;
  const std::string baseline = temporary.folders.baselines + "/Disc.png";
  SECTION("another size")
  {
    WritePNG(MakeBlank(32, 32), baseline);
  }
  SECTION("not a picture")
  {
    std::ofstream(baseline) << "version https://git-lfs";
  }
  CHECK_FALSE(CompareWithBaseline(MakeDisc(), "Disc", { 255.0, 0.0 }, temporary.folders));
  CHECK(temporary.HasFailure("Disc.png"));
}
