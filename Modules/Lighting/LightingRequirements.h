/**
 * @file    LightingRequirements.h
 * @brief   what a scene's lighting needs, as one plain value
 *
 * The value alone decides which GLSL, textures and passes exist. Two scenes with equal requirements
 * share one program and differ in uniforms only; what a scene does not require is not in the
 * program at all, and leaving it out never changes the picture.
 */

#ifndef LightingRequirements_h
#define LightingRequirements_h

#include "PenumbraLightingModule.h" // For export macro

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkLight;
class vtkLightCollection;
class vtkVolumeProperty;

namespace penumbra
{

/// How light reaches a sample: from one direction everywhere (headlights too), from a point, or
/// from a point within a cone.
enum class LightKind
{
  Directional,
  Point,
  Spot
};
constexpr int NumberOfLightKinds = 3;

/// The shadow state of a light; the values are those of vtkVolumeLight::ShadowType.
enum class ShadowKind
{
  None,
  Soft,
  Hard
};
constexpr int NumberOfShadowKinds = 3;

/// How shadows are computed. Rays marches a shadow ray from every sample that needs one. The others
/// look up what was computed beforehand: Volume over the whole volume; along the rays of each light
/// DeepMap, by functions of a few nodes, and OpacityMap, in layers; Map, for hard shadows, where
/// these rays are first hidden.
enum class ShadowTechnique
{
  Rays,
  Volume,
  Map,
  DeepMap,
  OpacityMap
};

/// How matter reflects light; the values are those of vtkVolumeMaterial::ReflectionModelType.
enum class ReflectionModel
{
  Phong,
  BlinnPhong,
  OrenNayar,
  Ward,
  WardAnisotropic,
  CookTorrance,
  ReflectionMap
};

/// How the gradient of the scalar field is estimated; the values are those of
/// vtkIlluminatedVolumeMapper::GradientEstimatorType.
enum class GradientEstimator
{
  CentralDifferences,
  ForwardDifferences,
  BackwardDifferences,
  Sobel
};

/// What matter does with light (Max 1995): absorbs that from behind, emits its colour, both, or
/// absorbs and scatters the lights' once.
enum class OpticalModel
{
  Absorption,
  Emission,
  AbsorptionEmission,
  SingleScattering
};

/// What cropping hides: nothing, all outside of one box, or any selection of the 27 regions.
enum class CroppingKind
{
  None,
  Box,
  Regions
};

/// How a transfer function is evaluated: by a table, where that is accurate, else by a search among
/// its points.
enum class TransferFunctionLookup
{
  Table,
  Points
};

/// One line of a requirements listing.
struct RequirementEntry
{
  std::string Name;
  std::string Value;
  bool Needed;
};

struct PENUMBRALIGHTING_EXPORT LightingRequirements
{
  /// Lights matter in single scattering alone.
  OpticalModel Optics = OpticalModel::AbsorptionEmission;
  /// Lights whose diffuse or specular term can change the picture, by kind and shadow state.
  std::array<std::array<int, NumberOfShadowKinds>, NumberOfLightKinds> Lights{};
  ShadowTechnique Technique = ShadowTechnique::Rays;
  /// Of kept shadows: rays are marched for many steps first, or those of some lights whole.
  bool NearShadowRays = false;
  /// Of kept shadows: how many steps towards every light are marched first, where they are few.
  int NearShadowSteps = 0;
  ReflectionModel Reflection = ReflectionModel::Phong;
  GradientEstimator Gradient = GradientEstimator::CentralDifferences;
  /// Gradients are looked up, not estimated at each sample.
  bool GradientTexture = false;
  /// Directional reflection fades out where the gradient is no more than noise.
  bool NoiseFading = false;
  bool Diffuse = false;
  bool Specular = false;
  bool TwoSidedLighting = false;
  /// Some point or spot light's intensity depends on its distance.
  bool Attenuation = false;
  bool GradientOpacity = false;
  int ClippingPlanes = 0;
  CroppingKind Cropping = CroppingKind::None;
  bool Mask = false;
  TransferFunctionLookup Opacity = TransferFunctionLookup::Table;
  /// Steps take the mean of the transfer functions over all scalars between their ends; else the
  /// functions at the sample in their middle.
  bool PreIntegrated = false;
  /// Lit steps that much is seen of are lit in two halves.
  bool HalvedSteps = false;
  /// Rays leap over bricks without visible matter.
  bool EmptySpaceSkipping = false;
  /// What rays do is counted in place of colours. No scene needs it; it is asked for.
  bool Counting = false;

  bool operator==(const LightingRequirements& other) const;
  bool operator!=(const LightingRequirements& other) const { return !(*this == other); }

  int GetNumberOfLights() const;
  int GetNumberOfLights(LightKind kind) const;
  int GetNumberOfLights(ShadowKind shadow) const;
  int GetNumberOfShadowedLights() const;
  bool NeedsLightPositions() const
  {
    return this->GetNumberOfLights(LightKind::Point) + this->GetNumberOfLights(LightKind::Spot) > 0;
  }
  bool IsShaded() const { return this->Optics == OpticalModel::SingleScattering; }
  /// A step's matter may lie anywhere in it, not in its middle alone.
  bool NeedsWholeSegments() const
  {
    return this->PreIntegrated || this->Mask || this->Cropping == CroppingKind::Regions;
  }
  bool NeedsColor() const { return this->Optics != OpticalModel::Absorption; }
  bool NeedsEnvironment() const
  {
    return this->Reflection == ReflectionModel::ReflectionMap && (this->Diffuse || this->Specular);
  }
  bool NeedsShadowRays() const
  {
    return this->GetNumberOfShadowedLights() > 0 &&
      (this->Technique == ShadowTechnique::Rays || this->NearShadowRays ||
        this->NearShadowSteps > 0);
  }
  bool HasFresnelTerm() const { return this->Reflection == ReflectionModel::CookTorrance; }
  bool HasPreferredDirection() const
  {
    return this->Reflection == ReflectionModel::WardAnisotropic;
  }
  bool NeedsNormal() const { return this->GetNumberOfLights() > 0 || this->NeedsEnvironment(); }
  bool NeedsGradient() const { return this->NeedsNormal() || this->GradientOpacity; }

  /// All requirements with their values, in the order of the data.
  std::vector<RequirementEntry> GetEntries() const;
  /// Names of what this scene does not need, one each.
  std::vector<std::string> GetLeftOut() const;
};

/// What of the scene the requirements depend on.
struct LightedScene
{
  /// The transfer functions, Shade and the material of the first component; a vtkVolumeMaterial's
  /// reflection model too. Not null.
  vtkVolumeProperty* Property = nullptr;
  /// Empty: as Shade of the property says, single scattering, or absorption and emission.
  std::optional<OpticalModel> Optics;
  GradientEstimator Gradient = GradientEstimator::CentralDifferences;
  bool GradientTexture = false;
  /// The material's environment map can be shown.
  bool EnvironmentMap = false;
  /// The renderer's lights. Null counts as empty.
  vtkLightCollection* Lights = nullptr;
  bool TwoSidedLighting = true;
  int ClippingPlanes = 0;
  CroppingKind Cropping = CroppingKind::None;
  bool Mask = false;
  TransferFunctionLookup Opacity = TransferFunctionLookup::Table;
  /// The transfer functions change much within a step.
  bool SteepOpacity = false;
  /// Between voxels the scalar is interpolated linearly; else it is the nearest voxel's.
  bool LinearInterpolation = false;
  /// Enough bricks of the volume hold no visible matter, and may be leapt over.
  bool EmptySpace = false;
};

/// The one function that turns a scene into its requirements. It depends on its argument alone.
PENUMBRALIGHTING_EXPORT LightingRequirements ComputeLightingRequirements(const LightedScene& scene);

/// Kind of a light as the requirements count it.
PENUMBRALIGHTING_EXPORT LightKind GetLightKind(vtkLight* light);

/// Shadow state of a light; a plain vtkLight has none.
PENUMBRALIGHTING_EXPORT ShadowKind GetShadowKind(vtkLight* light);

/// The technique's name in scene files and reports.
PENUMBRALIGHTING_EXPORT const char* GetName(ShadowTechnique technique);

/// By which model a property reflects light: Phong's, unless it is a vtkVolumeMaterial.
PENUMBRALIGHTING_EXPORT ReflectionModel GetReflectionModel(vtkVolumeProperty* property);

/// Whether the light's diffuse or specular term can change a picture of this material. The ambient
/// term needs no light in the program.
PENUMBRALIGHTING_EXPORT bool LightMatters(vtkLight* light, vtkVolumeProperty* property);

/**
 * The sum of ambient colours times intensities over all lights that are on. Where every one of them
 * is a plain vtkLight with black ambient colour it is white, so that scenes made for the stock
 * mapper keep their ambient light. No light on: black.
 */
PENUMBRALIGHTING_EXPORT std::array<double, 3> ComputeAmbientLight(vtkLightCollection* lights);

}

#endif
