#include "EnvironmentHarmonics.h"

#include "vtkMath.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

namespace penumbra
{
namespace
{
using Complex = std::complex<double>;
using ComplexColor = std::array<Complex, 3>;

constexpr double LargestRemainder = 0.05 / 255.0;
constexpr int LargestDegree = 384;

/// The sum of values[k] exp(-2 pi i m k / size) over k, for every m (Cooley and Tukey).
class FourierTransform
{
public:
  /// The size is a power of two.
  explicit FourierTransform(int size)
    : Reversed(size, 0)
    , Roots(size / 2)
  {
    for (int i = 1; i < size; ++i)
    {
      this->Reversed[i] = this->Reversed[i / 2] / 2 + (i % 2) * (size / 2);
    }
    for (int i = 0; i < size / 2; ++i)
    {
      this->Roots[i] = std::polar(1.0, -2.0 * vtkMath::Pi() * i / size);
    }
  }

  void Apply(std::vector<Complex>& values) const
  {
    const int size = static_cast<int>(values.size());
    for (int i = 0; i < size; ++i)
    {
      if (i < this->Reversed[i])
      {
        std::swap(values[i], values[this->Reversed[i]]);
      }
    }
    for (int half = 1; half < size; half *= 2)
    {
      const int rootStep = size / (2 * half);
      for (int start = 0; start < size; start += 2 * half)
      {
        for (int i = 0; i < half; ++i)
        {
          Combine(values[start + i], values[start + i + half], this->Roots[i * rootStep]);
        }
      }
    }
  }

private:
  // std::complex's own product looks for NaN, which takes most of the time.
  static void Combine(Complex& even, Complex& odd, const Complex& root)
  {
    const Complex turned(odd.real() * root.real() - odd.imag() * root.imag(),
      odd.real() * root.imag() + odd.imag() * root.real());
    odd = even - turned;
    even += turned;
  }

  std::vector<int> Reversed;
  std::vector<Complex> Roots;
};

/// The coefficients of exp(i m azimuth) on every ring: those of one order m after the other.
struct RingSpectra
{
  int Orders;
  int Rings;
  std::vector<ComplexColor> Values;

  RingSpectra(int orders, int rings)
    : Orders(orders)
    , Rings(rings)
    , Values(static_cast<std::size_t>(orders) * rings)
  {
  }
  ComplexColor* GetOrder(int order)
  {
    return this->Values.data() + static_cast<std::size_t>(order) * this->Rings;
  }
};

template <typename Action>
void ForEach(int count, Action action)
{
  vtkSMPTools::For(0, count,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        action(static_cast<int>(i));
      }
    });
}

// Azimuths count from the first column here; turning a map about the poles turns its blur alike.
void Analyse(const SphereGrid& grid, const FourierTransform& transform, RingSpectra& spectra)
{
  ForEach(grid.Rings,
    [&](int ring)
    {
      std::vector<Complex> values(grid.Columns);
      const auto* ringValues = &grid.Values[static_cast<std::size_t>(ring) * grid.Columns];
      for (int channel = 0; channel < 3; ++channel)
      {
        for (int column = 0; column < grid.Columns; ++column)
        {
          values[column] = ringValues[column][channel];
        }
        transform.Apply(values);
        for (int order = 0; order < spectra.Orders; ++order)
        {
          spectra.GetOrder(order)[ring][channel] = values[order];
        }
      }
    });
}

// Values are real: order -m is the conjugate of order m, and so the two make twice its real part.
void Synthesise(RingSpectra& spectra, const FourierTransform& transform, SphereGrid& grid)
{
  ForEach(grid.Rings,
    [&](int ring)
    {
      std::vector<Complex> values(grid.Columns);
      auto* ringValues = &grid.Values[static_cast<std::size_t>(ring) * grid.Columns];
      for (int channel = 0; channel < 3; ++channel)
      {
        std::fill(values.begin(), values.end(), 0.0);
        for (int order = 0; order < spectra.Orders; ++order)
        {
          const double share = order == 0 ? 1.0 : 2.0;
          values[order] = share * std::conj(spectra.GetOrder(order)[ring][channel]);
        }
        transform.Apply(values);
        for (int column = 0; column < grid.Columns; ++column)
        {
          ringValues[column][channel] = values[column].real();
        }
      }
    });
}

/// The Legendre functions of one order m, normalised: their squares times exp(i m azimuth)'s
/// integrate to 1 over the sphere. By the recurrence
///   P(l) = (cos P(l - 1) - b(l - 1) P(l - 2)) / b(l), b(l)^2 = (l^2 - m^2) / (4 l^2 - 1).
class LegendreFunctions
{
public:
  LegendreFunctions(int order, int degrees)
    : Order(order)
    , Steps(degrees, 0.0)
    , First(std::sqrt(0.25 / vtkMath::Pi()))
  {
    for (int k = 1; k <= order; ++k)
    {
      this->First *= std::sqrt(1.0 + 0.5 / k);
    }
    for (int degree = order + 1; degree < degrees; ++degree)
    {
      const double square = static_cast<double>(degree) * degree;
      this->Steps[degree] =
        std::sqrt((square - static_cast<double>(order) * order) / (4.0 * square - 1.0));
    }
  }

  /// Calls visit(degree, value) for every degree from the order on.
  template <typename Visitor>
  void Visit(double polarAngle, Visitor visit) const
  {
    const double cosine = std::cos(polarAngle);
    const int degrees = static_cast<int>(this->Steps.size());
    double before = 0.0;
    double value = this->First * std::pow(std::sin(polarAngle), this->Order);
    visit(this->Order, value);
    for (int degree = this->Order + 1; degree < degrees; ++degree)
    {
      const double next = (cosine * value - this->Steps[degree - 1] * before) / this->Steps[degree];
      before = value;
      value = next;
      visit(degree, value);
    }
  }

private:
  int Order;
  std::vector<double> Steps;
  double First;
};

void ConvolveOrder(int order, const std::vector<double>& factors, int rings, ComplexColor* spectra)
{
  const int degrees = static_cast<int>(factors.size());
  const LegendreFunctions legendre(order, degrees);
  std::vector<ComplexColor> coefficients(degrees);
  for (int ring = 0; ring < rings; ++ring)
  {
    const ComplexColor& flux = spectra[ring];
    legendre.Visit((ring + 0.5) * vtkMath::Pi() / rings,
      [&](int degree, double value)
      {
        for (int channel = 0; channel < 3; ++channel)
        {
          coefficients[degree][channel] += value * flux[channel];
        }
      });
  }
  for (int degree = order; degree < degrees; ++degree)
  {
    for (Complex& coefficient : coefficients[degree])
    {
      coefficient *= factors[degree];
    }
  }
  for (int ring = 0; ring < rings; ++ring)
  {
    ComplexColor sum{};
    legendre.Visit((ring + 0.5) * vtkMath::Pi() / rings,
      [&](int degree, double value)
      {
        for (int channel = 0; channel < 3; ++channel)
        {
          sum[channel] += value * coefficients[degree][channel];
        }
      });
    spectra[ring] = sum;
  }
}
}

//------------------------------------------------------------------------------
std::vector<double> ComputeLobeFactors(double power)
{
  std::vector<double> factors{ 1.0, (power + 1.0) / (power + 2.0) };
  // 4 pi times the integral of the kernel's square is the sum of (2 l + 1) f(l)^2 (Parseval). What
  // the degrees up to here leave of it bounds the results' change (Cauchy and Schwarz), for values
  // of at most 1/2 about their middle.
  double remainder = 2.0 * (power + 1.0) * (power + 1.0) / (2.0 * power + 1.0) - 1.0;
  for (int degree = 1;; ++degree)
  {
    remainder -= (2.0 * degree + 1.0) * factors[degree] * factors[degree];
    if (degree == LargestDegree || 0.25 * remainder <= LargestRemainder * LargestRemainder)
    {
      return factors;
    }
    // f(l + 1) = f(l - 1) (n - l + 1) / (n + l + 2), from Legendre's equation by parts.
    factors.push_back(factors[degree - 1] * (power - degree + 1.0) / (power + degree + 2.0));
  }
}

//------------------------------------------------------------------------------
void Convolve(SphereGrid& grid, const std::vector<double>& factors)
{
  const FourierTransform transform(grid.Columns);
  RingSpectra spectra(static_cast<int>(factors.size()), grid.Rings);
  Analyse(grid, transform, spectra);
  ForEach(spectra.Orders,
    [&](int order) { ConvolveOrder(order, factors, grid.Rings, spectra.GetOrder(order)); });
  Synthesise(spectra, transform, grid);
}

}
