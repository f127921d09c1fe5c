#include "SceneNames.h"

namespace penumbra
{

//------------------------------------------------------------------------------
const NamedValues<FacetDistribution>& NamesOf(FacetDistribution)
{
  static const NamedValues<FacetDistribution> names = {
    { "beckmann", FacetDistribution::Beckmann },
    { "gaussian", FacetDistribution::Gaussian },
  };
  return names;
}

//------------------------------------------------------------------------------
const NamedValues<GradientEstimator>& NamesOf(GradientEstimator)
{
  static const NamedValues<GradientEstimator> names = {
    { "central", GradientEstimator::CentralDifferences },
    { "forward", GradientEstimator::ForwardDifferences },
    { "backward", GradientEstimator::BackwardDifferences },
    { "sobel", GradientEstimator::Sobel },
  };
  return names;
}

//------------------------------------------------------------------------------
const NamedValues<LightFrame>& NamesOf(LightFrame)
{
  static const NamedValues<LightFrame> names = {
    { "scene", LightFrame::Scene },
    { "camera", LightFrame::Camera },
  };
  return names;
}

//------------------------------------------------------------------------------
const NamedValues<LightType>& NamesOf(LightType)
{
  static const NamedValues<LightType> names = {
    { "directional", LightType::Directional },
    { "point", LightType::Point },
    { "spot", LightType::Spot },
    { "headlight", LightType::Headlight },
  };
  return names;
}

//------------------------------------------------------------------------------
const NamedValues<OpticalModel>& NamesOf(OpticalModel)
{
  static const NamedValues<OpticalModel> names = {
    { "single-scattering", OpticalModel::SingleScattering },
    { "absorption-emission", OpticalModel::AbsorptionEmission },
    { "absorption", OpticalModel::Absorption },
    { "emission", OpticalModel::Emission },
  };
  return names;
}

//------------------------------------------------------------------------------
const NamedValues<ReflectionModel>& NamesOf(ReflectionModel)
{
  static const NamedValues<ReflectionModel> names = {
    { "phong", ReflectionModel::Phong },
    { "blinn-phong", ReflectionModel::BlinnPhong },
    { "oren-nayar", ReflectionModel::OrenNayar },
    { "ward", ReflectionModel::Ward },
    { "ward-anisotropic", ReflectionModel::WardAnisotropic },
    { "cook-torrance", ReflectionModel::CookTorrance },
    { "reflection-map", ReflectionModel::ReflectionMap },
  };
  return names;
}

//------------------------------------------------------------------------------
const NamedValues<RendererChoice>& NamesOf(RendererChoice)
{
  static const NamedValues<RendererChoice> names = {
    { "penumbra", RendererChoice::Penumbra },
    { "vtk", RendererChoice::StockMapper },
    { "reference", RendererChoice::Reference },
  };
  return names;
}

//------------------------------------------------------------------------------
const NamedValues<ShadowKind>& NamesOf(ShadowKind)
{
  static const NamedValues<ShadowKind> names = {
    { "none", ShadowKind::None },
    { "soft", ShadowKind::Soft },
    { "hard", ShadowKind::Hard },
  };
  return names;
}

//------------------------------------------------------------------------------
const NamedValues<TechniqueChoice>& NamesOf(TechniqueChoice)
{
  static const NamedValues<TechniqueChoice> names = {
    { "auto", TechniqueChoice::Auto },
    { "rays", TechniqueChoice::Rays },
    { "volume", TechniqueChoice::Volume },
    { "map", TechniqueChoice::Map },
    { "deep-map", TechniqueChoice::DeepMap },
    { "opacity-map", TechniqueChoice::OpacityMap },
  };
  return names;
}

}
