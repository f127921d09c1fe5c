/**
 * @file    Median.h
 * @brief   what stands for times that were measured several times
 */

#ifndef Median_h
#define Median_h

#include <algorithm>
#include <vector>

namespace penumbra
{

/// The middle value, or the mean of the two in the middle; 0 of none.
inline double Median(std::vector<double> values)
{
  if (values.empty())
  {
    return 0.0;
  }
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

}

#endif
