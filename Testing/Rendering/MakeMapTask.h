/**
 * @file    MakeMapTask.h
 * @brief   maps of lights with room for all that is asked
 */

#ifndef MakeMapTask_h
#define MakeMapTask_h

#include "ShadowMapPlan.h"

namespace penumbra
{

inline ShadowMapTask MakeMapTask(double span, int lights)
{
  ShadowMapTask task;
  task.Span = span;
  task.Lights = lights;
  task.LargestSize = 2048;
  task.LargestBytes = std::size_t(1) << 40;
  return task;
}

}

#endif
