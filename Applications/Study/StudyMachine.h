/**
 * @file    StudyMachine.h
 * @brief   what a study's times were measured on
 */

#ifndef StudyMachine_h
#define StudyMachine_h

#include <nlohmann/json.hpp>

namespace penumbra
{

/// Processor, number of logical processors, memory in MiB and operating system.
nlohmann::ordered_json DescribeMachine();

}

#endif
