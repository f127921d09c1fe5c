/**
 * @file    StabilityCases.h
 * @brief   stiff and extreme scenes, and what is to come of them
 */

#ifndef StabilityCases_h
#define StabilityCases_h

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace penumbra
{

struct StabilityCase
{
  std::string Name;
  /// A scene file's content; its volume is one of WriteStabilityVolumes'.
  nlohmann::ordered_json Scene;
  /// In grey levels of 255, against the reference. Below 0: bad input, which has to be refused.
  double Bound = 1.0;
};

/// All cases, in the order of their groups.
std::vector<StabilityCase> GetStabilityCases();

/// The volumes that the cases name. @throw std::runtime_error where one cannot be written.
void WriteStabilityVolumes(const std::filesystem::path& folder);

}

#endif
