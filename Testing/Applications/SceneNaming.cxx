#include "Catch.h"
#include "SceneNames.h"

#include <set>
#include <string>

using namespace penumbra;

namespace
{
template <typename Value>
void CheckNames(Value last)
{
  std::set<std::string> names;
  for (int value = 0; value <= static_cast<int>(last); ++value)
  {
    names.insert(NameOf(static_cast<Value>(value)));
  }
  CHECK(names.size() == static_cast<std::size_t>(last) + 1);
  CHECK(NamesOf(last).size() == names.size());
}
}

TEST_CASE("Every value has a name of its own in scene files")
{
  CheckNames(FacetDistribution::Gaussian);
  CheckNames(GradientEstimator::Sobel);
  CheckNames(LightFrame::Camera);
  CheckNames(LightType::Headlight);
  CheckNames(OpticalModel::SingleScattering);
  CheckNames(ReflectionModel::ReflectionMap);
  CheckNames(RendererChoice::Reference);
  CheckNames(ShadowKind::Hard);
  CheckNames(TechniqueChoice::OpacityMap);
}
