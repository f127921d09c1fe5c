#include "Catch.h"
#include "ShadowedVolume.h"
#include "VTKMessages.h"

#include <vtkBitArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkSOADataArrayTemplate.h>

#include <cmath>
#include <limits>

using namespace penumbra;

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

VolumeGrid MakeGrid(int scalarType = VTK_FLOAT)
{
  VolumeGrid grid;
  grid.dimensions = { 6, 7, 8 };
  grid.scalarType = scalarType;
  return grid;
}

double Stripes(const Point& point)
{
  return 60.0 + 25.0 * std::round(std::sin(point[0] + 2.0 * point[1]) + std::cos(3.0 * point[2]));
}

/// Opacity 0 at low, 0.4 at high.
std::vector<float> Shadow(
  const vtkSmartPointer<vtkImageData>& volume, double low = 0.0, double high = 127.0)
{
  ShadowedVolume scene(volume);
  scene.Opacity->AddPoint(low, 0.0);
  scene.Opacity->AddPoint(high, 0.4);
  scene.AddDirectional({ 0.4, -0.3, 1.0 });
  return scene.Compute();
}
}

TEST_CASE("All types of scalars give the same visibility")
{
  const int type = GENERATE(VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
    VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG_LONG, VTK_DOUBLE);
  CHECK(GetLargestDifference(Shadow(SampleField(MakeGrid(type), Stripes)),
          Shadow(SampleField(MakeGrid(), Stripes))) == 0.0);
}

TEST_CASE("Scalars in any layout of memory give the same visibility")
{
  const auto volume = SampleField(MakeGrid(), Stripes);
  const std::vector<float> expected = Shadow(volume);
  vtkNew<vtkSOADataArrayTemplate<float>> array;
  array->SetNumberOfComponents(1);
  array->DeepCopy(volume->GetPointData()->GetScalars());
  volume->GetPointData()->SetScalars(array);
  CHECK(GetLargestDifference(Shadow(volume), expected) == 0.0);
}

TEST_CASE("Bits are scalars of 0 and 1")
{
  const auto isSet = [](const Point& point) { return point[0] > 2.0 ? 1.0 : 0.0; };
  const auto volume = SampleField(MakeGrid(), isSet);
  const std::vector<float> expected = Shadow(volume, 0.0, 1.0);
  vtkNew<vtkBitArray> bits;
  bits->DeepCopy(volume->GetPointData()->GetScalars());
  volume->GetPointData()->SetScalars(bits);
  CHECK(GetLargestDifference(Shadow(volume, 0.0, 1.0), expected) == 0.0);
}

TEST_CASE("Large scalars keep the digits of their differences")
{
  const double offset = GENERATE(-2147483000.0, 2147483000.0);
  const auto volume =
    SampleField(MakeGrid(VTK_INT), [&](const Point& point) { return offset + Stripes(point); });
  CHECK(GetLargestDifference(
          Shadow(volume, offset, offset + 127.0), Shadow(SampleField(MakeGrid(), Stripes))) < 1e-6);
}

TEST_CASE("NaN and -Inf count as the smallest finite value, Inf as the largest, with a warning")
{
  const int type = GENERATE(VTK_FLOAT, VTK_DOUBLE);
  const auto sample = [&](double nan, double low, double high)
  {
    return SampleField(MakeGrid(type),
      [=](const Point& point)
      {
        const double value = Stripes(point);
        const double odd = point[1] == 2.0 ? nan : point[1] == 3.0 ? low : high;
        return point[0] == 1.0 ? odd : std::min(std::max(value, 20.0), 100.0);
      });
  };
  const std::vector<float> expected = Shadow(sample(20.0, 20.0, 100.0));
  const auto volume = sample(NaN, -Infinity, Infinity);
  VTKMessages messages;
  CHECK(GetLargestDifference(Shadow(volume), expected) == 0.0);
  CHECK_THAT(messages.Text(),
    Catch::Matchers::ContainsSubstring("NaN or -Inf count as the smallest finite value"));
  CHECK(std::isnan(volume->GetScalarComponentAsDouble(1, 2, 0, 0)));
}

TEST_CASE("A volume without any finite value counts as 0")
{
  const auto volume = SampleField(MakeGrid(), [](const Point&) { return NaN; });
  VTKMessages messages;
  const auto zeros = SampleField(MakeGrid(), [](const Point&) { return 0.0; });
  CHECK(GetLargestDifference(Shadow(volume, -1.0, 1.0), Shadow(zeros, -1.0, 1.0)) == 0.0);
}

TEST_CASE("Voxels of 1e30 leave the others their digits")
{
  const auto sample = [](double huge)
  {
    return SampleField(
      MakeGrid(), [=](const Point& point) { return point[2] == 7.0 ? huge : Stripes(point); });
  };
  // The light is in the middle, so that no ray comes near the huge values.
  const auto shadow = [](const vtkSmartPointer<vtkImageData>& volume)
  {
    ShadowedVolume scene(volume);
    scene.Opacity->AddPoint(127.0, 0.4);
    scene.AddPoint({ 3.0, 3.0, 2.0 });
    std::vector<float> visibility = scene.Compute();
    visibility.resize(6 * 7 * 7);
    return visibility;
  };
  CHECK(GetLargestDifference(shadow(sample(1e30)), shadow(sample(127.0))) < 1e-6);
}

TEST_CASE("A property that asks for the nearest voxel gets voxels, not what is between them")
{
  VolumeGrid grid;
  grid.dimensions = { 2, 2, 9 };
  const auto volume =
    SampleField(grid, [](const Point& point) { return point[2] == 4.0 ? 100.0 : 0.0; });
  ShadowedVolume scene(volume);
  scene.Opacity->AddPoint(100.0, 0.5);
  scene.Property->SetInterpolationTypeToNearest();
  scene.Filter->SetSampleDistance(0.125);
  scene.AddDirectional({ 0.0, 0.0, 1.0 });
  CHECK(GetLargestError(scene,
          [](const Point& point)
          {
            const double inside = 4.5 - std::min(std::max(point[2], 3.5), 4.5);
            return std::pow(0.5, inside);
          }) < 2e-6);
}
