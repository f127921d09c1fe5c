/**
 * @file    QuadratureRule.h
 * @brief   the rule of Gauss and Kronrod with 3 and 7 nodes, on [0, 1]
 *
 * Kronrod's 7 nodes contain Gauss's 3: they integrate polynomials of degree 11 exactly, those of
 * degree 5. Their difference estimates the error of the 3, and so bounds that of the 7 where the
 * integrand is smooth.
 */

#ifndef QuadratureRule_h
#define QuadratureRule_h

#include <array>

namespace penumbra::reference
{

constexpr int NumberOfNodes = 7;
constexpr int NumberOfGaussNodes = 3;

/// Of the Gauss nodes among all.
constexpr std::array<int, NumberOfGaussNodes> GaussNodes = { 1, 3, 5 };

using NodeValues = std::array<double, NumberOfNodes>;

struct QuadratureRule
{
  QuadratureRule();

  /// Ascending.
  NodeValues Nodes;
  NodeValues Weights;
  std::array<double, NumberOfGaussNodes> GaussWeights;
  /// Row i: weights of the integral from 0 to node i.
  std::array<NodeValues, NumberOfNodes> WeightsToNode;
  /// Row j: at all nodes the polynomial that is 1 at Gauss node j and 0 at the other two.
  std::array<NodeValues, NumberOfGaussNodes> QuadraticBasis;
};

/// The only one.
extern const QuadratureRule Rule;

}

#endif
