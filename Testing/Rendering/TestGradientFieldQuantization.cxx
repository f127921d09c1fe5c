#include "Catch.h"
#include "GradientField.h"
#include "MakeArray.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace penumbra;

namespace
{
using Index = std::array<int, 3>;

constexpr Index NoiseSize = { 17, 13, 11 };

vtkSmartPointer<vtkDataArray> MakeNoise()
{
  std::mt19937 random(3);
  std::vector<double> values;
  for (int i = 0; i < NoiseSize[0] * NoiseSize[1] * NoiseSize[2]; ++i)
  {
    values.push_back(random() % 2001 - 1000.0);
  }
  return MakeArray(VTK_SHORT, values);
}

std::vector<int> GetValues(const QuantizedGradientField& field)
{
  return field.Bits == 8 ? std::vector<int>(field.Values8.begin(), field.Values8.end())
                         : std::vector<int>(field.Values16.begin(), field.Values16.end());
}

double GetLargestValue(int bits)
{
  return bits == 8 ? 127.0 : 32767.0;
}

double GetAngle(const double a[3], const double b[3])
{
  return vtkMath::DegreesFromRadians(vtkMath::AngleBetweenVectors(a, b));
}
}

TEST_CASE("A quantized gradient is off by half a step at most")
{
  const auto scalars = MakeNoise();
  for (const int bits : { 8, 16 })
  {
    for (const GradientEstimator estimator :
      { GradientEstimator::CentralDifferences, GradientEstimator::ForwardDifferences,
        GradientEstimator::BackwardDifferences, GradientEstimator::Sobel })
    {
      INFO(bits << " bits, estimator " << static_cast<int>(estimator));
      const auto exact = ComputeGradientField(scalars, NoiseSize, estimator);
      const auto field = QuantizeGradientField(scalars, NoiseSize, estimator, bits);
      const std::vector<int> values = GetValues(field);
      REQUIRE(values.size() == exact.size());
      CHECK(field.Bytes == exact.size() * bits / 8);
      CHECK((field.Values8.empty() || field.Values16.empty()));

      const double step = field.Scale / GetLargestValue(bits);
      double largestError = 0.0;
      for (size_t i = 0; i < exact.size(); ++i)
      {
        largestError = std::max(largestError, std::abs(values[i] * step - exact[i]));
      }
      // The exact gradients are in single precision.
      const double rounding = field.Scale * std::numeric_limits<float>::epsilon();
      CHECK(largestError <= 0.5 * step + rounding);
      CHECK(field.LargestError == Approx(largestError).margin(rounding));
      // Of 7293 components one nearly meets the worst case.
      CHECK(largestError >= 0.49 * step);
    }
  }
}

TEST_CASE("The largest component is full scale, whatever its sign, and 0 stays 0")
{
  for (const int bits : { 8, 16 })
  {
    for (const double sign : { -1.0, 1.0 })
    {
      INFO(bits << " bits, sign " << sign);
      const auto scalars = MakeArray(VTK_SHORT, { 0.0, 0.0, 0.0, sign * 37.0, sign * 40.0, 40.0 });
      const auto field =
        QuantizeGradientField(scalars, { 6, 1, 1 }, GradientEstimator::ForwardDifferences, bits);
      const double largest = GetLargestValue(bits);
      const double end = 40.0 - sign * 40.0;
      CHECK(field.Scale == std::max(37.0, end));
      const auto quantize = [&](double gradient)
      { return static_cast<int>(std::lround(gradient / field.Scale * largest)); };
      CHECK(GetValues(field) ==
        std::vector<int>{ 0, 0, 0, 0, 0, 0, quantize(sign * 37.0), 0, 0, quantize(sign * 3.0), 0, 0,
          quantize(end), 0, 0, 0, 0, 0 });
    }
    const auto falling = QuantizeGradientField(MakeArray(VTK_FLOAT, { 0.7, 0.0, -0.1 }),
      { 3, 1, 1 }, GradientEstimator::ForwardDifferences, bits);
    CHECK(GetValues(falling)[0] == -GetLargestValue(bits));
  }
}

TEST_CASE("A constant volume has gradients of 0 and no error")
{
  for (const int bits : { 8, 16 })
  {
    const auto field = QuantizeGradientField(MakeArray(VTK_FLOAT, std::vector<double>(8, 5.0)),
      { 2, 2, 2 }, GradientEstimator::Sobel, bits);
    CHECK(GetValues(field) == std::vector<int>(24, 0));
    CHECK((field.Scale == 0.0 && field.LargestError == 0.0 && field.MeanAngularError == 0.0));
  }
}

TEST_CASE("The errors are those computed by hand")
{
  // Gradients by forward differences: (100, 1, 0), (0, 1, 0), (100, 0, 0) and 0; with 8 bits 1
  // becomes 1.27, and that 1.
  const auto scalars = MakeArray(VTK_SHORT, { 0.0, 100.0, 1.0, 101.0 });
  const auto field =
    QuantizeGradientField(scalars, { 2, 2, 1 }, GradientEstimator::ForwardDifferences, 8);
  CHECK(GetValues(field) == std::vector<int>{ 127, 1, 0, 0, 1, 0, 127, 0, 0, 0, 0, 0 });
  // Rounding, of angles too.
  CHECK(field.LargestError == Approx(1.0 - 100.0 / 127.0).epsilon(1e-12));
  const double exact[3] = { 100.0, 1.0, 0.0 };
  const double quantized[3] = { 127.0, 1.0, 0.0 };
  const double magnitude = vtkMath::Norm(exact);
  const double mean = magnitude * GetAngle(exact, quantized) / (magnitude + 1.0 + 100.0);
  CHECK(mean == Approx(0.0606).epsilon(1e-3)); // atan(1/100) - atan(1/127), and its weight
  CHECK(field.MeanAngularError == Approx(mean).epsilon(1e-9));
}

TEST_CASE("A direction that is lost counts as 90 degrees")
{
  // (100, .3, 0), (0, .3, 0), (100, 0, 0) and 0, whose .3 becomes 0.
  const auto scalars = MakeArray(VTK_DOUBLE, { 0.0, 100.0, 0.3, 100.3 });
  const auto field =
    QuantizeGradientField(scalars, { 2, 2, 1 }, GradientEstimator::ForwardDifferences, 8);
  CHECK(GetValues(field) == std::vector<int>{ 127, 0, 0, 0, 0, 0, 127, 0, 0, 0, 0, 0 });
  const double magnitude = std::hypot(100.0, 0.3);
  const double turned = vtkMath::DegreesFromRadians(std::atan(0.003));
  const double mean = (magnitude * turned + 0.3 * 90.0) / (magnitude + 0.3 + 100.0);
  // Rounding of values of 100 that differ by .3.
  CHECK(field.MeanAngularError == Approx(mean).epsilon(1e-9));
}

TEST_CASE("16 bits are about 256 times as accurate as 8")
{
  const auto scalars = MakeNoise();
  for (const GradientEstimator estimator :
    { GradientEstimator::CentralDifferences, GradientEstimator::Sobel })
  {
    const auto coarse = QuantizeGradientField(scalars, NoiseSize, estimator, 8);
    const auto fine = QuantizeGradientField(scalars, NoiseSize, estimator, 16);
    CHECK(fine.Scale == coarse.Scale);
    CHECK(fine.Bytes == 2 * coarse.Bytes);
    // 32767 / 127 = 258. The largest errors are within 2 % of half a step; lost directions and
    // chance keep the mean angles from being quite proportional.
    CHECK(coarse.LargestError / fine.LargestError == Approx(258.0).epsilon(0.04));
    CHECK(coarse.MeanAngularError / fine.MeanAngularError == Approx(258.0).epsilon(0.1));
  }
}
