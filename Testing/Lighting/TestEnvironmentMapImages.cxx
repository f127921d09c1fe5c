#include "Catch.h"
#include "EnvironmentSamples.h"

#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <cmath>
#include <limits>
#include <string>

using namespace penumbra;
using Catch::Matchers::ContainsSubstring;

namespace
{
using Images = std::vector<vtkImageData*>;
using Color = std::array<double, 3>;

vtkSmartPointer<vtkImageData> MakeConstantImage(
  int type, const std::vector<double>& pixel, int width = 8, int height = 4, int depth = 1)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, depth);
  image->AllocateScalars(type, static_cast<int>(pixel.size()));
  for (std::size_t component = 0; component < pixel.size(); ++component)
  {
    image->GetPointData()->GetScalars()->FillComponent(
      static_cast<int>(component), pixel[component]);
  }
  return image;
}

std::string GetRefusal(const Images& images)
{
  std::string reason;
  CHECK_FALSE(MakeEnvironmentMap(images, reason));
  return reason;
}

std::string GetRefusal(const vtkSmartPointer<vtkImageData>& image)
{
  return GetRefusal(Images{ image });
}

void CheckMean(int type, const std::vector<double>& pixel, const Color& mean)
{
  const auto image = MakeConstantImage(type, pixel);
  std::string reason;
  const auto map = MakeEnvironmentMap({ image }, reason);
  REQUIRE(map);
  CHECK(reason.empty());
  for (int channel = 0; channel < 3; ++channel)
  {
    CHECK(MeanRadiance(*map)[channel] == Approx(mean[channel]).epsilon(1e-6));
  }
}
}

TEST_CASE("Integers count over their range and floating-point values as they are")
{
  CheckMean(VTK_UNSIGNED_CHAR, { 255.0, 51.0, 0.0 }, { 1.0, 0.2, 0.0 });
  CheckMean(VTK_UNSIGNED_SHORT, { 65535.0, 13107.0, 0.0 }, { 1.0, 0.2, 0.0 });
  CheckMean(VTK_FLOAT, { 30.0, 0.25, 0.0 }, { 30.0, 0.25, 0.0 });
  CheckMean(VTK_DOUBLE, { 30.0, 0.25, 0.0 }, { 30.0, 0.25, 0.0 });
}

TEST_CASE("One or two components are grey, and alpha is ignored")
{
  CheckMean(VTK_FLOAT, { 0.5 }, { 0.5, 0.5, 0.5 });
  CheckMean(VTK_FLOAT, { 0.5, 0.125 }, { 0.5, 0.5, 0.5 });
  CheckMean(VTK_FLOAT, { 0.5, 0.25, 0.75, 0.125 }, { 0.5, 0.25, 0.75 });
}

TEST_CASE("Mean radiance counts each pixel by its solid angle")
{
  const Environment polar = [](const Direction& w) { return w[1] * w[1]; };
  const double third = 1.0 / 3.0;
  CHECK(
    MeanRadiance(MakeEquirectangular(256, 128, polar).MakeMap())[0] == Approx(third).margin(1e-4));
  CHECK(MeanRadiance(MakeCubeFaces(64, polar).MakeMap())[0] == Approx(third).margin(1e-4));
  // A quarter of the polar angle is no quarter of the sphere.
  const auto cap = MakeImage(1, 4, { 1.0, 0.0, 0.0, 0.0 });
  std::string reason;
  CHECK(MeanRadiance(MakeEnvironmentMap({ cap }, reason).value())[0] ==
    Approx(0.5 * (1.0 - std::sqrt(0.5))));
}

TEST_CASE("Images that show no environment are refused with the reason")
{
  CHECK_THAT(GetRefusal(Images{}), ContainsSubstring("0 images"));
  CHECK_THAT(GetRefusal(Images{ nullptr }), ContainsSubstring("missing"));
  CHECK_THAT(GetRefusal(vtkSmartPointer<vtkImageData>::New()), ContainsSubstring("empty"));
  const auto withoutScalars = vtkSmartPointer<vtkImageData>::New();
  withoutScalars->SetDimensions(8, 4, 1);
  CHECK_THAT(GetRefusal(withoutScalars), ContainsSubstring("empty"));
  CHECK_THAT(GetRefusal(MakeConstantImage(VTK_FLOAT, { 1.0 }, 4, 4, 4)),
    ContainsSubstring("not two-dimensional"));
  CHECK_THAT(GetRefusal(MakeConstantImage(VTK_FLOAT, std::vector<double>(5, 1.0))),
    ContainsSubstring("5 components"));
  CHECK_THAT(GetRefusal(MakeConstantImage(VTK_SHORT, { 1.0 })), ContainsSubstring("type short"));
  CHECK_THAT(GetRefusal(MakeConstantImage(VTK_INT, { 1.0 })), ContainsSubstring("type int"));
}

TEST_CASE("An environment map with too few values for its size is refused")
{
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(8, 4, 1);
  vtkNew<vtkFloatArray> values;
  values->SetNumberOfTuples(31);
  values->Fill(1.0);
  image->GetPointData()->SetScalars(values);
  CHECK_THAT(GetRefusal(image), ContainsSubstring("empty"));
}

TEST_CASE("Values that are no radiance are refused wherever they are")
{
  const double infinity = std::numeric_limits<double>::infinity();
  const auto refuse = [](int type, double value)
  {
    const auto image = MakeConstantImage(type, { 1.0, 1.0, 1.0 });
    image->SetScalarComponentFromDouble(7, 3, 0, 2, value);
    return GetRefusal(image);
  };
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    CHECK_THAT(refuse(type, std::nan("")), ContainsSubstring("not a number"));
    CHECK_THAT(refuse(type, infinity), ContainsSubstring("infinite"));
    CHECK_THAT(refuse(type, -infinity), ContainsSubstring("infinite"));
    CHECK_THAT(refuse(type, -0.5), ContainsSubstring("negative"));
  }
  CHECK_THAT(refuse(VTK_DOUBLE, 1e300), ContainsSubstring("too large"));
}

TEST_CASE("Six images that make no cube are refused, and the one that is wrong is named")
{
  const auto face = MakeConstantImage(VTK_FLOAT, { 1.0 }, 4, 4);
  const auto larger = MakeConstantImage(VTK_FLOAT, { 1.0 }, 5, 5);
  const auto oblong = MakeConstantImage(VTK_FLOAT, { 1.0 }, 4, 3);
  CHECK_THAT(GetRefusal(Images{ face, face }), ContainsSubstring("2 images"));
  CHECK_THAT(GetRefusal(Images(7, face)), ContainsSubstring("7 images"));
  CHECK_THAT(GetRefusal(Images{ face, face, oblong, face, face, face }),
    ContainsSubstring("image 3 of 6 is not square"));
  CHECK_THAT(GetRefusal(Images(6, oblong)), ContainsSubstring("image 1 of 6 is not square"));
  CHECK_THAT(GetRefusal(Images{ face, larger, face, face, face, face }),
    ContainsSubstring("image 2 of 6 is not of the first one's size (5 x 5, not 4 x 4)"));
  CHECK_THAT(GetRefusal(Images{ face, face, face, face, face, nullptr }),
    ContainsSubstring("image 6 of 6 is missing"));
}
