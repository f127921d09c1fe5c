/**
 * @file CoveringSet.h
 * @brief Few combinations of options among which every pair of options occurs.
 */
#ifndef CoveringSet_h
#define CoveringSet_h

#include <functional>
#include <vector>

namespace penumbra
{
/// One value for each option.
using Combination = std::vector<int>;

/**
 * Combinations in which any two values of any two options occur together, built greedily: each next
 * one is the best of many random ones that hold the first pair still missing (after Cohen et al.,
 * "The AETG system", IEEE Transactions on Software Engineering 23(7), 1997). The same set on every
 * call. levels: how many values each option has.
 * @throw std::runtime_error where a pair occurs in no combination that is allowed.
 */
std::vector<Combination> MakeCoveringSet(
  const std::vector<int>& levels, const std::function<bool(const Combination&)>& isAllowed);

/// How many pairs of values of two options occur in no combination.
int CountMissingPairs(const std::vector<int>& levels, const std::vector<Combination>& combinations);
}

#endif
