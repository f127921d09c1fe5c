/**
 * @file    ConvergenceOrder.h
 * @brief   the power of the step by which errors of the error study fall
 */

#ifndef ConvergenceOrder_h
#define ConvergenceOrder_h

#include "ErrorStudy.h"

#include <optional>
#include <string>
#include <vector>

namespace penumbra
{

/**
 * From the next coarser step of the same scene and variant to that of `row`, a place in `rows`. The
 * rounding of the window to 8 bits is taken out of both errors first: squared errors add up,
 * and its share is taken for the error at the finest step, which is at most 1 / sqrt(12) = 0.29
 * grey levels. Empty where either error is less than twice that, or there is no coarser row.
 */
std::optional<double> OrderAt(const std::vector<ErrorRow>& rows, std::size_t row);

/// Of the finest steps that have one. Empty where none have.
std::optional<double> ObservedOrder(
  const std::vector<ErrorRow>& rows, const std::string& scene, const std::string& variant);

}

#endif
