#include "Catch.h"
#include "GradientField.h"
#include "MakeArray.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace penumbra;

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr std::array<int, 3> Size = { 5, 4, 3 };

constexpr GradientEstimator Estimators[] = { GradientEstimator::CentralDifferences,
  GradientEstimator::ForwardDifferences, GradientEstimator::BackwardDifferences,
  GradientEstimator::Sobel };

// Whole numbers from 0 to 100, one a voxel.
std::vector<double> MakeValues(const std::array<int, 3>& size)
{
  std::mt19937 random(5);
  std::vector<double> values(size[0] * size[1] * size[2]);
  std::generate(values.begin(), values.end(), [&] { return random() % 101; });
  values[7] = 0.0;
  values[8] = 100.0;
  return values;
}

std::vector<double> Map(std::vector<double> values, double factor, double offset)
{
  for (double& value : values)
  {
    value = factor * value + offset;
  }
  return values;
}

bool AreSame(const QuantizedGradientField& a, const QuantizedGradientField& b)
{
  return a.Values8 == b.Values8 && a.Values16 == b.Values16 && a.Scale == b.Scale &&
    a.LargestError == b.LargestError && a.MeanAngularError == b.MeanAngularError;
}
}

TEST_CASE("The gradients of equal values are equal, whatever their type")
{
  const std::vector<double> values = MakeValues(Size);
  const auto doubles = MakeArray(VTK_DOUBLE, values);
  for (const GradientEstimator estimator : Estimators)
  {
    const auto gradients = ComputeGradientField(doubles, Size, estimator);
    const auto quantized = QuantizeGradientField(doubles, Size, estimator, 16);
    for (const int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
           VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG,
           VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_FLOAT })
    {
      INFO("type " << type << ", estimator " << static_cast<int>(estimator));
      const auto scalars = MakeArray(type, values);
      CHECK(ComputeGradientField(scalars, Size, estimator) == gradients);
      CHECK(AreSame(QuantizeGradientField(scalars, Size, estimator, 16), quantized));
    }
  }
}

TEST_CASE("A large offset takes no digits from the gradients")
{
  const std::vector<double> values = MakeValues(Size);
  for (const GradientEstimator estimator : Estimators)
  {
    const auto gradients = ComputeGradientField(MakeArray(VTK_SHORT, values), Size, estimator);
    // Sums of 22 such values are below 2^53, and exact.
    CHECK(ComputeGradientField(
            MakeArray(VTK_INT, Map(values, 1.0, 2147483000.0)), Size, estimator) == gradients);
    CHECK(ComputeGradientField(MakeArray(VTK_DOUBLE, Map(values, 1.0, -1e14)), Size, estimator) ==
      gradients);
  }
}

TEST_CASE("NaN and -Inf count as the smallest finite value, +Inf as the largest")
{
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    // Neither end of the range is 0.
    std::vector<double> values = Map(MakeValues(Size), 1.0, 20.0);
    std::vector<double> holes = values;
    values[21] = values[22] = values[0] = 20.0;
    values[37] = values[59] = 120.0;
    holes[21] = holes[0] = std::nan("");
    holes[22] = -Infinity;
    holes[37] = holes[59] = Infinity;
    for (const GradientEstimator estimator : Estimators)
    {
      const auto scalars = MakeArray(type, holes);
      CHECK(ComputeGradientField(scalars, Size, estimator) ==
        ComputeGradientField(MakeArray(type, values), Size, estimator));
      CHECK(AreSame(QuantizeGradientField(scalars, Size, estimator, 8),
        QuantizeGradientField(MakeArray(type, values), Size, estimator, 8)));
    }
    const auto nothing =
      QuantizeGradientField(MakeArray(type, { std::nan(""), Infinity, -Infinity, std::nan("") }),
        { 2, 2, 1 }, GradientEstimator::Sobel, 8);
    CHECK(nothing.Scale == 0.0);
    CHECK(nothing.Values8 == std::vector<signed char>(12, 0));
  }
}

TEST_CASE("Values at the ends of double precision are quantized like others")
{
  const std::vector<double> values = MakeValues(Size);
  for (const GradientEstimator estimator : Estimators)
  {
    const auto usual = QuantizeGradientField(MakeArray(VTK_DOUBLE, values), Size, estimator, 8);
    // Powers of 2, so that only their exponents differ.
    for (const int exponent : { -1020, -200, 200, 980 })
    {
      INFO("exponent " << exponent << ", estimator " << static_cast<int>(estimator));
      const double factor = std::ldexp(1.0, exponent);
      const auto field =
        QuantizeGradientField(MakeArray(VTK_DOUBLE, Map(values, factor, 0.0)), Size, estimator, 8);
      CHECK(field.Scale == factor * usual.Scale);
      CHECK(field.Values8 == usual.Values8);
      CHECK(field.MeanAngularError == usual.MeanAngularError);
    }
    const double largest = std::numeric_limits<double>::max();
    const auto widest = QuantizeGradientField(
      MakeArray(VTK_DOUBLE, { -largest, largest, largest, 0.0 }), { 2, 2, 1 }, estimator, 8);
    CHECK(std::isfinite(widest.Scale));
    CHECK(std::isfinite(widest.LargestError));
    CHECK(std::isfinite(widest.MeanAngularError));
  }
}

TEST_CASE("Threads change nothing")
{
  const std::array<int, 3> size = { 40, 30, 50 };
  const auto scalars = MakeArray(VTK_FLOAT, Map(MakeValues(size), 0.37, 0.0));
  for (const GradientEstimator estimator : Estimators)
  {
    const auto compute = [&](const vtkSMPTools::Config& config)
    {
      QuantizedGradientField field;
      vtkSMPTools::LocalScope(
        config, [&] { field = QuantizeGradientField(scalars, size, estimator, 16); });
      return field;
    };
    const auto alone = compute(vtkSMPTools::Config("Sequential"));
    CHECK(alone.MeanAngularError > 0.0);
    for (const int threads : { 2, 3, 7 })
    {
      INFO(threads << " threads, estimator " << static_cast<int>(estimator));
      CHECK(AreSame(compute({ threads, "STDThread", false }), alone));
    }
  }
}
