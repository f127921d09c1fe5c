#include "CoveringSet.h"

#include <algorithm>
#include <array>
#include <random>
#include <set>
#include <stdexcept>

namespace penumbra
{
namespace
{
// First option, its value, second option, its value.
using Pair = std::array<int, 4>;
using Pairs = std::set<Pair>;

Pairs GetPairs(const Combination& combination)
{
  Pairs pairs;
  const int options = static_cast<int>(combination.size());
  for (int first = 0; first < options; ++first)
  {
    for (int second = first + 1; second < options; ++second)
    {
      pairs.insert({ first, combination[first], second, combination[second] });
    }
  }
  return pairs;
}

Pairs GetAllPairs(const std::vector<int>& levels)
{
  Pairs pairs;
  const int options = static_cast<int>(levels.size());
  for (int first = 0; first < options; ++first)
  {
    for (int second = first + 1; second < options; ++second)
    {
      for (int value = 0; value < levels[first] * levels[second]; ++value)
      {
        pairs.insert({ first, value % levels[first], second, value / levels[first] });
      }
    }
  }
  return pairs;
}

int CountNew(const Pairs& pairs, const Pairs& missing)
{
  return static_cast<int>(std::count_if(
    pairs.begin(), pairs.end(), [&](const Pair& pair) { return missing.count(pair) > 0; }));
}

Combination MakeRandom(const std::vector<int>& levels, const Pair& pair, std::mt19937& generator)
{
  // Remainders, for distributions differ between standard libraries.
  Combination combination;
  for (const int level : levels)
  {
    combination.push_back(static_cast<int>(generator() % level));
  }
  combination[pair[0]] = pair[1];
  combination[pair[2]] = pair[3];
  return combination;
}
}

//------------------------------------------------------------------------------
std::vector<Combination> MakeCoveringSet(
  const std::vector<int>& levels, const std::function<bool(const Combination&)>& isAllowed)
{
  std::mt19937 generator(1);
  std::vector<Combination> combinations;
  Pairs missing = GetAllPairs(levels);
  while (!missing.empty())
  {
    Combination best;
    int mostNew = 0;
    for (int candidate = 0; candidate < 100; ++candidate)
    {
      const Combination combination = MakeRandom(levels, *missing.begin(), generator);
      const int count = isAllowed(combination) ? CountNew(GetPairs(combination), missing) : 0;
      if (count > mostNew)
      {
        best = combination;
        mostNew = count;
      }
    }
    if (best.empty())
    {
      throw std::runtime_error("a pair of options occurs in no combination that is allowed");
    }
    combinations.push_back(best);
    for (const Pair& pair : GetPairs(best))
    {
      missing.erase(pair);
    }
  }
  return combinations;
}

//------------------------------------------------------------------------------
int CountMissingPairs(const std::vector<int>& levels, const std::vector<Combination>& combinations)
{
  Pairs missing = GetAllPairs(levels);
  for (const Combination& combination : combinations)
  {
    for (const Pair& pair : GetPairs(combination))
    {
      missing.erase(pair);
    }
  }
  return static_cast<int>(missing.size());
}

}
