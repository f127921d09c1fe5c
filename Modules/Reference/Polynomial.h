/**
 * @file    Polynomial.h
 * @brief   polynomials on [0, 1]
 *
 * Along a ray a trilinear field is a cubic polynomial within each cell.
 */

#ifndef Polynomial_h
#define Polynomial_h

#include <algorithm>
#include <array>

namespace penumbra::reference
{

template <int Degree>
struct Polynomial
{
  /// Of the powers of u, from the constant one on.
  std::array<double, Degree + 1> Coefficients{};

  double At(double u) const
  {
    double value = this->Coefficients[Degree];
    for (int power = Degree - 1; power >= 0; --power)
    {
      value = value * u + this->Coefficients[power];
    }
    return value;
  }

  bool IsConstant() const
  {
    return std::all_of(this->Coefficients.begin() + 1, this->Coefficients.end(),
      [](double coefficient) { return coefficient == 0.0; });
  }
};

using Cubic = Polynomial<3>;

template <int First, int Second>
Polynomial<First + Second> Product(const Polynomial<First>& a, const Polynomial<Second>& b)
{
  Polynomial<First + Second> product;
  for (int i = 0; i <= First; ++i)
  {
    for (int j = 0; j <= Second; ++j)
    {
      product.Coefficients[i + j] += a.Coefficients[i] * b.Coefficients[j];
    }
  }
  return product;
}

template <int Degree>
void Add(Polynomial<Degree>& sum, const Polynomial<Degree>& other)
{
  for (int power = 0; power <= Degree; ++power)
  {
    sum.Coefficients[power] += other.Coefficients[power];
  }
}

/// Bernstein coefficients: b_i = sum over k <= i of binomial(i, k) / binomial(n, k) a_k.
template <int Degree>
std::array<double, Degree + 1> ToBernstein(const Polynomial<Degree>& polynomial)
{
  std::array<double, Degree + 1> bernstein{};
  for (int i = 0; i <= Degree; ++i)
  {
    double ratio = 1.0;
    for (int k = 0; k <= i; ++k)
    {
      bernstein[i] += ratio * polynomial.Coefficients[k];
      ratio *= static_cast<double>(i - k) / (Degree - k);
    }
  }
  return bernstein;
}

}

#endif
