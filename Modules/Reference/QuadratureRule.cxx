#include "QuadratureRule.h"

namespace penumbra::reference
{
namespace
{
// Kronrod 1965, on [-1, 1], from the middle outwards.
constexpr double KronrodNodes[] = { 0.0, 0.4342437493468025580021, 0.7745966692414833770359,
  0.9604912687080202834235 };
constexpr double KronrodWeights[] = { 0.4509165386584741423451, 0.4013974147759622229051,
  0.2684880898683334407286, 0.1046562260264672651938 };

/// The polynomial through these nodes that is 1 at one of them and 0 at the others.
template <std::size_t Count>
double Lagrange(const std::array<double, Count>& nodes, std::size_t number, double x)
{
  double product = 1.0;
  for (std::size_t other = 0; other < Count; ++other)
  {
    if (other != number)
    {
      product *= (x - nodes[other]) / (nodes[number] - nodes[other]);
    }
  }
  return product;
}
}

const QuadratureRule Rule;

//------------------------------------------------------------------------------
QuadratureRule::QuadratureRule()
  : GaussWeights{ 5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0 }
{
  constexpr int middle = NumberOfNodes / 2;
  for (int i = 0; i <= middle; ++i)
  {
    this->Nodes[middle - i] = 0.5 - 0.5 * KronrodNodes[i];
    this->Nodes[middle + i] = 0.5 + 0.5 * KronrodNodes[i];
    this->Weights[middle - i] = this->Weights[middle + i] = 0.5 * KronrodWeights[i];
  }
  for (int i = 0; i < NumberOfNodes; ++i)
  {
    for (int k = 0; k < NumberOfNodes; ++k)
    {
      // The rule itself integrates these polynomials of degree 6 exactly.
      double sum = 0.0;
      for (int j = 0; j < NumberOfNodes; ++j)
      {
        sum += this->Weights[j] * Lagrange(this->Nodes, k, this->Nodes[i] * this->Nodes[j]);
      }
      this->WeightsToNode[i][k] = this->Nodes[i] * sum;
    }
  }
  std::array<double, NumberOfGaussNodes> gauss;
  for (int j = 0; j < NumberOfGaussNodes; ++j)
  {
    gauss[j] = this->Nodes[GaussNodes[j]];
  }
  for (int k = 0; k < NumberOfNodes; ++k)
  {
    for (int j = 0; j < NumberOfGaussNodes; ++j)
    {
      this->QuadraticBasis[j][k] = Lagrange(gauss, j, this->Nodes[k]);
    }
  }
}

}
