#include "Catch.h"
#include "GradientDifferences.h"
#include "GradientField.h"
#include "MakeArray.h"
#include "ScalarRange.h"

#include <vtkShortArray.h>

#include <algorithm>
#include <limits>
#include <random>

using namespace penumbra;

namespace
{
constexpr GradientEstimator Estimators[] = { GradientEstimator::CentralDifferences,
  GradientEstimator::ForwardDifferences, GradientEstimator::BackwardDifferences,
  GradientEstimator::Sobel };

constexpr std::array<int, 3> Size = { 7, 5, 4 };

// Whole numbers of which both ends of the range stand next to each other in corners.
std::vector<double> MakeValues(double low, double high)
{
  std::mt19937 random(11);
  std::uniform_int_distribution<int> value(static_cast<int>(low), static_cast<int>(high));
  std::vector<double> values(Size[0] * Size[1] * Size[2]);
  std::generate(values.begin(), values.end(), [&] { return value(random); });
  values[0] = low;
  values[1] = high;
  return values;
}

void CheckExact(int type, const std::vector<double>& values, GradientEstimator estimator)
{
  const auto scalars = MakeArray(type, values);
  REQUIRE(AreDifferencesExact(type, ComputeScalarRange(scalars), estimator));
  const auto gradients = ComputeGradientField(scalars, Size, estimator);
  const auto differences = ComputeGradientDifferences(scalars, Size, estimator);
  REQUIRE(differences->GetNumberOfValues() == static_cast<vtkIdType>(gradients.size()));
  const double scale = GetDifferenceScale(estimator) / 32767.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < gradients.size(); ++i)
  {
    const double difference = differences->GetValue(static_cast<vtkIdType>(i)) * scale;
    largest = std::max(largest, std::abs(difference - gradients[i]));
  }
  // The field's gradients are in single precision.
  CHECK(largest <= 32768.0 * std::numeric_limits<float>::epsilon());
}
}

TEST_CASE("Differences of whole scalars are their gradients, exactly")
{
  for (const GradientEstimator estimator : Estimators)
  {
    INFO("estimator " << static_cast<int>(estimator));
    const double range = estimator == GradientEstimator::Sobel ? 1489.0 : 32767.0;
    CheckExact(VTK_UNSIGNED_CHAR, MakeValues(0.0, 255.0), estimator);
    CheckExact(VTK_SIGNED_CHAR, MakeValues(-128.0, 127.0), estimator);
    CheckExact(VTK_SHORT, MakeValues(-1000.0, range - 1000.0), estimator);
    CheckExact(VTK_UNSIGNED_SHORT, MakeValues(65535.0 - range, 65535.0), estimator);
    CheckExact(VTK_INT, MakeValues(-8e7, range - 8e7), estimator);
    CheckExact(VTK_UNSIGNED_INT, MakeValues(8e7 - range, 8e7), estimator);
    CheckExact(VTK_LONG_LONG, MakeValues(8e7 - range, 8e7), estimator);
  }
}

TEST_CASE("What does not fit into sixteen bits, or is not whole, is not exact")
{
  for (const GradientEstimator estimator : Estimators)
  {
    INFO("estimator " << static_cast<int>(estimator));
    const double range = estimator == GradientEstimator::Sobel ? 1489.0 : 32767.0;
    CHECK(AreDifferencesExact(VTK_INT, { 0.0, range }, estimator));
    CHECK_FALSE(AreDifferencesExact(VTK_INT, { -1.0, range }, estimator));
    CHECK_FALSE(AreDifferencesExact(VTK_INT, { 8e7, 8e7 + 1.0 }, estimator));
    CHECK_FALSE(AreDifferencesExact(VTK_INT, { -8e7 - 1.0, -8e7 }, estimator));
    CHECK_FALSE(AreDifferencesExact(VTK_FLOAT, { 0.0, 1.0 }, estimator));
    CHECK_FALSE(AreDifferencesExact(VTK_DOUBLE, { 0.0, 1.0 }, estimator));
  }
}
