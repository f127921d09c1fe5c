/**
 * @file    WaitFor.h
 * @brief   lets a window live until something holds
 */

#ifndef WaitFor_h
#define WaitFor_h

#include <functional>

namespace penumbra
{

/// Answers events until the condition holds, at most so many seconds. Returns whether it does.
bool WaitFor(const std::function<bool()>& condition, double seconds = 60.0);

}

#endif
