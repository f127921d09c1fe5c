/**
 * @file    SceneNames.h
 * @brief   what scene files call the values of enumerations
 */

#ifndef SceneNames_h
#define SceneNames_h

#include "SceneDescription.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace penumbra
{

/// In the order in which a message lists them.
template <typename Value>
using NamedValues = std::vector<std::pair<std::string, Value>>;

/// All values of an enumeration with their names; which value is given does not matter.
///@{
const NamedValues<FacetDistribution>& NamesOf(FacetDistribution);
const NamedValues<GradientEstimator>& NamesOf(GradientEstimator);
const NamedValues<LightFrame>& NamesOf(LightFrame);
const NamedValues<LightType>& NamesOf(LightType);
const NamedValues<OpticalModel>& NamesOf(OpticalModel);
const NamedValues<ReflectionModel>& NamesOf(ReflectionModel);
const NamedValues<RendererChoice>& NamesOf(RendererChoice);
const NamedValues<ShadowKind>& NamesOf(ShadowKind);
const NamedValues<TechniqueChoice>& NamesOf(TechniqueChoice);
///@}

/// The value's own.
template <typename Value>
const std::string& NameOf(Value value)
{
  const NamedValues<Value>& names = NamesOf(value);
  return std::find_if(
    names.begin(), names.end(), [value](const auto& named) { return named.second == value; })
    ->first;
}

}

#endif
