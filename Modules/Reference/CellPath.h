/**
 * @file    CellPath.h
 * @brief   trilinear fields along a straight path through one cell
 */

#ifndef CellPath_h
#define CellPath_h

#include "Polynomial.h"

#include "vtkVector.h"

#include <array>

namespace penumbra::reference
{

/// Values at a cell's corners; that at (i, j, k) is number i + 2 j + 4 k.
using CellCorners = std::array<double, 8>;

/**
 * A path p(u) = Start + u Step, 0 <= u <= 1, in the cell's own coordinates. Along it a trilinear
 * field, a sum of the products of 1 and x, 1 and y, 1 and z, is a cubic polynomial of u.
 */
class CellPath
{
public:
  CellPath(const vtkVector3d& start, const vtkVector3d& step)
    : X{ { start[0], step[0] } }
    , Y{ { start[1], step[1] } }
    , Z{ { start[2], step[2] } }
    , XY(Product(X, Y))
    , XZ(Product(X, Z))
    , YZ(Product(Y, Z))
    , XYZ(Product(XY, Z))
  {
  }

  Cubic Along(const CellCorners& f) const
  {
    const double x = f[1] - f[0];
    const double y = f[2] - f[0];
    const double z = f[4] - f[0];
    const double xy = (f[3] - f[2]) - x;
    const double xz = (f[5] - f[4]) - x;
    const double yz = (f[6] - f[4]) - y;
    const double xyz = ((f[7] - f[6]) - (f[5] - f[4])) - xy;
    Cubic cubic;
    for (int power = 3; power >= 0; --power)
    {
      double& sum = cubic.Coefficients[power];
      sum = xyz * this->XYZ.Coefficients[power];
      if (power <= 2)
      {
        sum += xy * this->XY.Coefficients[power] + xz * this->XZ.Coefficients[power] +
          yz * this->YZ.Coefficients[power];
      }
      if (power <= 1)
      {
        sum += x * this->X.Coefficients[power] + y * this->Y.Coefficients[power] +
          z * this->Z.Coefficients[power];
      }
    }
    cubic.Coefficients[0] += f[0];
    return cubic;
  }

private:
  Polynomial<1> X;
  Polynomial<1> Y;
  Polynomial<1> Z;
  Polynomial<2> XY;
  Polynomial<2> XZ;
  Polynomial<2> YZ;
  Polynomial<3> XYZ;
};

}

#endif
