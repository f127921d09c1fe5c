#include "Catch.h"
#include "CellPath.h"
#include "LevelCrossings.h"

using namespace penumbra::reference;

namespace
{
/// With these zeros.
template <std::size_t Count>
Polynomial<Count> MakePolynomial(const std::array<double, Count>& zeros)
{
  Polynomial<Count> polynomial;
  polynomial.Coefficients[0] = 1.0;
  for (const double zero : zeros)
  {
    auto& c = polynomial.Coefficients;
    for (int power = Count; power > 0; --power)
    {
      c[power] = c[power - 1] - zero * c[power];
    }
    c[0] *= -zero;
  }
  return polynomial;
}

template <int Degree>
std::vector<double> FindCrossings(
  const Polynomial<Degree>& polynomial, const std::vector<double>& levels)
{
  std::vector<double> crossings;
  AppendCrossings(polynomial, levels, crossings);
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}
}

TEST_CASE("All crossings of a cubic are found, to the last digits")
{
  const std::array<double, 3> zeros = GENERATE(std::array<double, 3>{ 0.2, 0.5, 0.9 },
    std::array<double, 3>{ 0.3, 0.3001, 0.7 }, std::array<double, 3>{ 1e-6, 0.5, 1.0 - 1e-6 });
  const auto crossings = FindCrossings(MakePolynomial(zeros), { 0.0 });
  REQUIRE(crossings.size() == 3);
  for (int i = 0; i < 3; ++i)
  {
    CHECK(crossings[i] == Approx(zeros[i]).margin(1e-12));
  }
}

TEST_CASE("Crossings outside of [0, 1] do not count")
{
  CHECK(FindCrossings(MakePolynomial<3>({ -0.5, 0.4, 1.3 }), { 0.0 }).size() == 1);
  CHECK(FindCrossings(MakePolynomial<3>({ -0.5, -0.1, 1.3 }), { 0.0 }).empty());
}

TEST_CASE("Every level has its crossings")
{
  // 4 u (1 - u), with its top 1 at 1/2.
  const Polynomial<2> parabola{ { 0.0, 4.0, -4.0 } };
  const auto crossings = FindCrossings(parabola, { -1.0, 0.75, 0.9999999, 1.0, 2.0 });
  REQUIRE(crossings.size() == 4);
  CHECK(crossings[0] == Approx(0.25));
  CHECK(crossings[3] == Approx(0.75));
  CHECK(crossings[1] == Approx(0.5 - 0.5 * std::sqrt(1e-7)));
}

TEST_CASE("A polynomial of degree 6 has its crossings too")
{
  const std::array<double, 6> zeros = { 0.05, 0.2, 0.35, 0.6, 0.8, 0.95 };
  const auto crossings = FindCrossings(MakePolynomial(zeros), { 0.0 });
  REQUIRE(crossings.size() == 6);
  for (int i = 0; i < 6; ++i)
  {
    CHECK(crossings[i] == Approx(zeros[i]).margin(1e-10));
  }
}

TEST_CASE("A zero is found where regula falsi is slow")
{
  const auto flat = [](double x) { return x < 0.123 ? -1e-12 : x - 0.12; };
  CHECK(FindZero(flat, 0.0, 1.0, 1e-9) == Approx(0.123).margin(1e-8));
  const auto steep = [](double x) { return std::pow(x, 9.0) - 1e-9; };
  CHECK(FindZero(steep, 0.0, 1.0) == Approx(0.1).margin(1e-12));
}

TEST_CASE("A trilinear field along a path is its cubic")
{
  const CellCorners f = { 1.0, -2.0, 3.5, 0.25, 7.0, 2.0, -1.0, 4.0 };
  const auto at = [&](double x, double y, double z)
  {
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      sum += f[corner] * (corner & 1 ? x : 1.0 - x) * (corner & 2 ? y : 1.0 - y) *
        (corner & 4 ? z : 1.0 - z);
    }
    return sum;
  };
  const Cubic cubic = CellPath({ 0.1, 0.9, 0.2 }, { 0.5, -0.7, 0.6 }).Along(f);
  for (const double u : { 0.0, 0.3, 0.77, 1.0 })
  {
    CHECK(cubic.At(u) == Approx(at(0.1 + 0.5 * u, 0.9 - 0.7 * u, 0.2 + 0.6 * u)).margin(1e-14));
  }
}
