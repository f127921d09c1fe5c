/**
 * @file    NumberText.h
 * @brief   numbers and counts as people read them
 */

#ifndef NumberText_h
#define NumberText_h

#include <cstddef>
#include <string>

namespace penumbra
{

/// `number` with at most six digits, such as 2.5.
std::string NumberText(double number);

/// Such as "1 image" or "3 images".
std::string CountText(std::size_t count, const std::string& what);

}

#endif
