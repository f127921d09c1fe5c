/**
 * @file    LobeTable.h
 * @brief   a lobe's integral for any direction, interpolated
 */

#ifndef LobeTable_h
#define LobeTable_h

#include "LobeIntegral.h"

#include <array>
#include <memory>
#include <mutex>

namespace penumbra::reference
{

/**
 * Over the faces of a cube, squares in which the integral is a polynomial of degree 7 each way
 * through its values at Chebyshev's nodes. A square is quartered where the polynomial's last
 * coefficients, which bound what is left out where the integral is smooth, exceed the tolerance.
 * Squares are filled in when they are first asked for; what they hold depends on nothing else.
 */
class LobeTable
{
public:
  /// `tolerance` is of values up to 1, of larger ones relative; it is never below the integral's.
  LobeTable(const LobeIntegral& integral, double tolerance);
  ~LobeTable();

  struct Result
  {
    Rgb Value{};
    /// Bound, where the integral is smooth.
    double Error = 0.0;
  };
  /// By any thread. `direction` is of unit length.
  Result LookUp(const vtkVector3d& direction) const;

private:
  static constexpr int Size = 8;
  using Coefficients = std::array<Rgb, Size * Size>;

  struct Square
  {
    int Face = 0;
    int Level = 0;
    double Left = -1.0;
    double Top = -1.0;
    double Width = 2.0;
    std::once_flag Filled;
    Coefficients Values{};
    double Error = 0.0;
    std::unique_ptr<std::array<Square, 4>> Quarters;
  };

  void Fill(Square& square) const;
  void Transform(const Coefficients& atNodes, Square& square) const;

  LobeIntegral Integral;
  double Tolerance;
  mutable std::array<Square, 6> Faces;
};

}

#endif
