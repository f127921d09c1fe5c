#include "LobeTable.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace penumbra::reference
{
namespace
{
// Squares of 1/1024 of a face: nothing narrower than a twentieth of a degree is resolved.
constexpr int MostLevels = 10;

/// On which face of the cube a direction is, and where, -1 to 1.
struct FacePoint
{
  int Face;
  double X;
  double Y;

  explicit FacePoint(const vtkVector3d& direction)
  {
    int axis = 0;
    for (int other = 1; other < 3; ++other)
    {
      axis = std::abs(direction[other]) > std::abs(direction[axis]) ? other : axis;
    }
    const double depth = std::abs(direction[axis]);
    this->Face = 2 * axis + (direction[axis] < 0.0 ? 1 : 0);
    this->X = std::clamp(direction[(axis + 1) % 3] / depth, -1.0, 1.0);
    this->Y = std::clamp(direction[(axis + 2) % 3] / depth, -1.0, 1.0);
  }
};

vtkVector3d GetDirection(int face, double x, double y)
{
  const int axis = face / 2;
  vtkVector3d direction;
  direction[axis] = face % 2 == 0 ? 1.0 : -1.0;
  direction[(axis + 1) % 3] = x;
  direction[(axis + 2) % 3] = y;
  return direction.Normalized();
}

double GetNode(int number, int count)
{
  return std::cos(vtkMath::Pi() * (number + 0.5) / count);
}

/// T_0(x) to T_(Count - 1)(x).
template <std::size_t Count>
std::array<double, Count> GetChebyshev(double x)
{
  std::array<double, Count> values;
  values[0] = 1.0;
  values[1] = x;
  for (std::size_t i = 2; i < Count; ++i)
  {
    values[i] = 2.0 * x * values[i - 1] - values[i - 2];
  }
  return values;
}
}

//------------------------------------------------------------------------------
LobeTable::LobeTable(const LobeIntegral& integral, double tolerance)
  : Integral(integral)
  , Tolerance(std::max(tolerance, integral.GetError()))
{
  for (int face = 0; face < 6; ++face)
  {
    this->Faces[face].Face = face;
  }
}

//------------------------------------------------------------------------------
LobeTable::~LobeTable() = default;

//------------------------------------------------------------------------------
void LobeTable::Transform(const Coefficients& atNodes, Square& square) const
{
  for (int i = 0; i < Size * Size; ++i)
  {
    const double scale = (i % Size == 0 ? 1.0 : 2.0) * (i / Size == 0 ? 1.0 : 2.0) / (Size * Size);
    for (int node = 0; node < Size * Size; ++node)
    {
      const double weight = scale * GetChebyshev<Size>(GetNode(node % Size, Size))[i % Size] *
        GetChebyshev<Size>(GetNode(node / Size, Size))[i / Size];
      for (int channel = 0; channel < 3; ++channel)
      {
        square.Values[i][channel] += weight * atNodes[node][channel];
      }
    }
  }
}

//------------------------------------------------------------------------------
void LobeTable::Fill(Square& square) const
{
  Coefficients atNodes;
  double largest = 1.0;
  for (int node = 0; node < Size * Size; ++node)
  {
    const double x = square.Left + square.Width * 0.5 * (1.0 + GetNode(node % Size, Size));
    const double y = square.Top + square.Width * 0.5 * (1.0 + GetNode(node / Size, Size));
    atNodes[node] = this->Integral.Evaluate(GetDirection(square.Face, x, y));
    largest = std::max(largest, *std::max_element(atNodes[node].begin(), atNodes[node].end()));
  }
  this->Transform(atNodes, square);
  Rgb last{};
  for (int i = 0; i < Size * Size; ++i)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      // Two each way: of an even function every other one is 0.
      const bool isLast = i % Size >= Size - 2 || i / Size >= Size - 2;
      last[channel] += isLast ? std::abs(square.Values[i][channel]) : 0.0;
    }
  }
  square.Error = *std::max_element(last.begin(), last.end());
  if (square.Error <= this->Tolerance * largest || square.Level == MostLevels)
  {
    return;
  }
  square.Quarters = std::make_unique<std::array<Square, 4>>();
  for (int i = 0; i < 4; ++i)
  {
    Square& quarter = (*square.Quarters)[i];
    quarter.Face = square.Face;
    quarter.Level = square.Level + 1;
    quarter.Width = 0.5 * square.Width;
    quarter.Left = square.Left + (i % 2) * quarter.Width;
    quarter.Top = square.Top + (i / 2) * quarter.Width;
  }
}

//------------------------------------------------------------------------------
LobeTable::Result LobeTable::LookUp(const vtkVector3d& direction) const
{
  const FacePoint point(direction);
  Square* square = &this->Faces[point.Face];
  std::call_once(square->Filled, [&] { this->Fill(*square); });
  while (square->Quarters)
  {
    const double middle = 0.5 * square->Width;
    const int quarter =
      (point.X < square->Left + middle ? 0 : 1) + (point.Y < square->Top + middle ? 0 : 2);
    square = &(*square->Quarters)[quarter];
    std::call_once(square->Filled, [&] { this->Fill(*square); });
  }
  const auto x = GetChebyshev<Size>(2.0 * (point.X - square->Left) / square->Width - 1.0);
  const auto y = GetChebyshev<Size>(2.0 * (point.Y - square->Top) / square->Width - 1.0);
  Result result;
  result.Error = std::max(square->Error, this->Integral.GetError());
  for (int i = 0; i < Size * Size; ++i)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      result.Value[channel] += square->Values[i][channel] * x[i % Size] * y[i / Size];
    }
  }
  return result;
}

}
