/**
 * @file    OneLine.h
 * @brief   messages as one line
 */

#ifndef OneLine_h
#define OneLine_h

#include <string>

namespace penumbra
{

/// `text` in one line of a length that can be read: names and texts from files may hold line ends.
std::string OneLine(std::string text);

}

#endif
