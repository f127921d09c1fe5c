#include "Catch.h"
#include "QuadratureRule.h"

#include <cmath>

using namespace penumbra::reference;

namespace
{
template <typename Function>
double Integrate(Function function, int parts)
{
  double sum = 0.0;
  for (int part = 0; part < parts; ++part)
  {
    for (int i = 0; i < NumberOfNodes; ++i)
    {
      sum += Rule.Weights[i] * function((part + Rule.Nodes[i]) / parts) / parts;
    }
  }
  return sum;
}

template <typename Function>
double IntegrateByGauss(Function function, int parts)
{
  double sum = 0.0;
  for (int part = 0; part < parts; ++part)
  {
    for (int j = 0; j < NumberOfGaussNodes; ++j)
    {
      sum += Rule.GaussWeights[j] * function((part + Rule.Nodes[GaussNodes[j]]) / parts) / parts;
    }
  }
  return sum;
}

double Power(double x, int exponent)
{
  return std::pow(x, exponent);
}
}

TEST_CASE("The rule is exact for polynomials of its degree, and no further")
{
  for (int degree = 0; degree <= 11; ++degree)
  {
    CAPTURE(degree);
    const auto monomial = [&](double x) { return Power(x, degree); };
    CHECK(Integrate(monomial, 1) == Approx(1.0 / (degree + 1)).epsilon(1e-14));
    const double gaussError = std::abs(IntegrateByGauss(monomial, 1) - 1.0 / (degree + 1));
    CHECK((degree <= 5 ? gaussError < 1e-15 : gaussError > 1e-5));
  }
  CHECK(std::abs(Integrate([](double x) { return Power(x, 12); }, 1) - 1.0 / 13.0) > 1e-10);
}

TEST_CASE("The rule converges with its order where the integrand is smooth")
{
  const auto function = [](double x) { return Power(x, 14); };
  const double exact = 1.0 / 15.0;
  const auto getOrder = [&](const auto& integrate, int parts)
  {
    const double coarse = std::abs(integrate(function, parts) - exact);
    const double fine = std::abs(integrate(function, 2 * parts) - exact);
    return std::log2(coarse / fine);
  };
  const auto kronrod = [](auto f, int parts) { return Integrate(f, parts); };
  const auto gauss = [](auto f, int parts) { return IntegrateByGauss(f, parts); };
  CHECK(getOrder(kronrod, 1) == Approx(12.0).margin(0.3));
  CHECK(getOrder(gauss, 8) == Approx(6.0).margin(0.3));
}

TEST_CASE("The difference of the two rules bounds the error of the better one")
{
  for (const double steepness : { 0.5, 3.0, 10.0, 30.0 })
  {
    const auto function = [&](double x) { return std::exp(-steepness * x); };
    const double exact = -std::expm1(-steepness) / steepness;
    const double error = std::abs(Integrate(function, 1) - exact);
    CHECK(error <= std::abs(Integrate(function, 1) - IntegrateByGauss(function, 1)));
  }
}

TEST_CASE("Integrals to each node are exact for polynomials of degree 6")
{
  for (int degree = 0; degree <= 6; ++degree)
  {
    for (int i = 0; i < NumberOfNodes; ++i)
    {
      double sum = 0.0;
      for (int k = 0; k < NumberOfNodes; ++k)
      {
        sum += Rule.WeightsToNode[i][k] * Power(Rule.Nodes[k], degree);
      }
      CHECK(sum == Approx(Power(Rule.Nodes[i], degree + 1) / (degree + 1)).margin(1e-14));
    }
  }
}

TEST_CASE("The quadratic basis is that of Gauss's nodes")
{
  for (int k = 0; k < NumberOfNodes; ++k)
  {
    double square = 0.0;
    for (int j = 0; j < NumberOfGaussNodes; ++j)
    {
      square += Power(Rule.Nodes[GaussNodes[j]], 2) * Rule.QuadraticBasis[j][k];
    }
    CHECK(square == Approx(Power(Rule.Nodes[k], 2)).margin(1e-14));
  }
}
