/**
 * @file Refusal.h
 * @brief What is said of input that is refused.
 */
#ifndef Refusal_h
#define Refusal_h

#include "InputError.h"

#include <string>

namespace penumbra
{
/// Empty where the task refuses nothing.
template <class Task>
std::string RefusalOf(const Task& task)
{
  try
  {
    task();
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return {};
}
}

#endif
