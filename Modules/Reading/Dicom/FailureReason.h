/**
 * @file    FailureReason.h
 * @brief   why a file cannot be read, from what was thrown
 */

#ifndef FailureReason_h
#define FailureReason_h

#include <exception>
#include <string>

namespace penumbra
{

/// In words for a user: those of a VolumeReadingError, but not of libraries.
std::string FailureReason(const std::exception& error);

}

#endif
