/**
 * @file    Process.h
 * @brief   what the operating system knows of this program
 */

#ifndef Process_h
#define Process_h

#include <cstdint>

namespace penumbra
{

/// Processor time that all threads have used so far, in seconds.
double ProcessorSeconds();

/// The most memory that the program has held at once, in bytes.
std::uint64_t PeakMemoryBytes();

/// Whether someone reads what is written to stderr.
bool IsTerminalAtStandardError();

}

#endif
