#include "Catch.h"
#include "StudyPicture.h"
#include "TemporaryFolder.h"

#include <cmath>

using namespace penumbra;

namespace
{
StudyPicture Gray(int width, int height, float level)
{
  StudyPicture picture{ width, height, {} };
  for (int pixel = 0; pixel < width * height; ++pixel)
  {
    picture.Values.insert(picture.Values.end(), { level, level, level, 1.0f });
  }
  return picture;
}
}

TEST_CASE("A picture that is read is the one that was written")
{
  const TemporaryFolder folder;
  StudyPicture picture = Gray(5, 3, 0.25f);
  picture.Values[7] = 0.125f;
  WriteStudyPicture(picture, folder.PathOf("p.mha"));
  const StudyPicture read = ReadStudyPicture(folder.PathOf("p.mha"));
  CHECK(read.Width == 5);
  CHECK(read.Height == 3);
  CHECK(read.Values == picture.Values);
}

TEST_CASE("Equal pictures have no error; alpha does not count")
{
  StudyPicture other = Gray(16, 16, 0.5f);
  other.Values[3] = 0.0f;
  const PictureError error = CompareWithReference(other, Gray(16, 16, 0.5f));
  CHECK(error.RootMeanSquare == 0.0);
  CHECK(error.Largest == 0.0);
  CHECK(error.StructuralSimilarity == Approx(1.0));
}

TEST_CASE("Errors are grey levels of 255 over red, green and blue")
{
  StudyPicture other = Gray(100, 10, 0.5f);
  // One of 3000 values is off by a fifth: beyond the 99.9 percentile of 3000 are 3.
  other.Values[0] += 0.2f;
  const PictureError one = CompareWithReference(other, Gray(100, 10, 0.5f));
  CHECK(one.Largest == Approx(51.0).epsilon(1e-5));
  CHECK(one.Mean == Approx(51.0 / 3000.0).epsilon(1e-5));
  CHECK(one.RootMeanSquare == Approx(51.0 / std::sqrt(3000.0)).epsilon(1e-5));
  CHECK(one.Percentile999 == 0.0);
  for (int pixel = 0; pixel < 4; ++pixel)
  {
    other.Values[4 * pixel + 1] = 0.7f;
  }
  CHECK(
    CompareWithReference(other, Gray(100, 10, 0.5f)).Percentile999 == Approx(51.0).epsilon(1e-5));
}

TEST_CASE("Pictures of different sizes cannot be compared")
{
  CHECK_THROWS_AS(CompareWithReference(Gray(4, 4, 0.0f), Gray(4, 5, 0.0f)), std::invalid_argument);
}

TEST_CASE("What is no picture is refused by name")
{
  const TemporaryFolder folder;
  CHECK_THROWS(ReadStudyPicture(folder.Write("p.mha", "no picture")));
}

TEST_CASE("Pixels that differ by a grey level are the same, and by two are not")
{
  StudyPicture picture{ 2, 2, std::vector<float>(16, 100.0f / 255.0f) };
  StudyPicture other = picture;
  other.Values[0] = 101.0f / 255.0f;
  other.Values[6] = 99.0f / 255.0f;
  CHECK(PartThatDiffers(picture, other) == 0.0);
  other.Values[0] = 102.0f / 255.0f;
  other.Values[1] = 110.0f / 255.0f;
  CHECK(PartThatDiffers(picture, other) == 0.25);
  // Alpha is not seen.
  other.Values[15] = 0.0f;
  CHECK(PartThatDiffers(picture, other) == 0.25);
  CHECK_THROWS(PartThatDiffers(picture, { 1, 1, std::vector<float>(4) }));
}
