/**
 * @file    SceneDescription.h
 * @brief   a scene file as plain values
 *
 * The structs mirror the keys of a scene file and their defaults. What is empty in an optional is
 * either absent from the scene, or chosen from the volume by ResolveScene (SceneDefaults.h), as
 * each says. Colours are linear, 0 to 1; angles are in degrees; matrices are row-major. The
 * volume's own lengths are those before its transform.
 */

#ifndef SceneDescription_h
#define SceneDescription_h

#include "LightingRequirements.h" // For ShadowKind, ReflectionModel and so on
#include "Vector3.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace penumbra
{

struct VolumeDescription
{
  std::filesystem::path File;

  /// What a .raw file does not say about itself; other formats ignore it.
  ///@{
  std::optional<std::array<int, 3>> Dimensions;
  std::optional<int> ScalarType;
  Vector3 Spacing = { 1.0, 1.0, 1.0 };
  Vector3 Origin = { 0.0, 0.0, 0.0 };
  std::array<double, 9> Direction = { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 };
  bool BigEndian = false;
  std::uint64_t HeaderBytes = 0;
  ///@}

  /// Series Instance UID, for DICOM. Empty: the series with the most voxels.
  std::optional<std::string> Series;

  /// The actor's matrix: invertible, without perspective.
  std::array<double, 16> Transform = { 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0,
    0.0, 0.0, 0.0, 1.0 };
  /// Kept interval of origin + index * spacing along each axis: x, x, y, y, z, z. Empty: all.
  std::optional<std::array<double, 6>> Cropping;
  /// A volume of the same dimensions whose zeros hide. Empty: nothing is hidden.
  std::optional<std::filesystem::path> Mask;
};

/// A function of the scalar value: x, then one or three values. Two points at one x are a step.
template <std::size_t NumberOfValues>
using FunctionPoints = std::vector<std::array<double, 1 + NumberOfValues>>;

struct Preset;

struct TransferFunctionDescription
{
  /// Gives what is empty below. Empty: chosen from the voxels, where it is needed.
  std::shared_ptr<const Preset> FromPreset;
  /// Opacity per unit distance, 0 to 1. Empty: the preset's.
  std::optional<FunctionPoints<1>> Opacity;
  /// Empty: the preset's.
  std::optional<FunctionPoints<3>> Color;
  /// Factor of the opacity, 0 to 1, over scalar units per mean voxel. Empty: none, or the preset's
  /// where the opacity is.
  std::optional<FunctionPoints<1>> GradientOpacity;
  /// In the volume's own lengths. Empty: 1, or the preset's where the opacity is.
  std::optional<double> OpacityUnitDistance;
};

enum class FacetDistribution
{
  Beckmann,
  Gaussian
};

/// What each is, and its range, says vtkVolumeMaterial.
struct MaterialDescription
{
  ReflectionModel Model = ReflectionModel::Phong;
  double Ambient = 0.1;
  double Diffuse = 0.7;
  double Specular = 0.2;
  double SpecularPower = 10.0;
  double Roughness = 0.3;
  double RoughnessX = 0.1;
  double RoughnessY = 0.5;
  Vector3 PreferredDirection = { 1.0, 0.0, 0.0 };
  double Slope = 0.3;
  FacetDistribution Distribution = FacetDistribution::Beckmann;
  double GaussianConstant = 1.0;
  Vector3 IndexOfRefraction = { 1.5, 1.5, 1.5 };
  /// One equirectangular image, or six of the directions +x, -x, +y, -y, +z and -z. Empty: none.
  std::vector<std::filesystem::path> EnvironmentMap;
  double NoiseFading = 0.0;
};

enum class LightType
{
  Directional,
  Point,
  Spot,
  Headlight
};

/// Where a light's position and direction are given: in the world, or from the eye with x to the
/// right, y up and z towards the viewer.
enum class LightFrame
{
  Scene,
  Camera
};

struct LightDescription
{
  LightType Type = LightType::Directional;
  std::string Name;
  bool On = true;
  LightFrame Frame = LightFrame::Scene;
  Vector3 Position = { 0.0, 0.0, 0.0 };
  /// The way the light travels.
  Vector3 Direction = { 0.0, 0.0, -1.0 };
  Vector3 Ambient = { 1.0, 1.0, 1.0 };
  Vector3 Diffuse = { 1.0, 1.0, 1.0 };
  Vector3 Specular = { 1.0, 1.0, 1.0 };
  double Intensity = 1.0;
  Vector3 Attenuation = { 1.0, 0.0, 0.0 };
  /// Half angle; 90 or more: no cone.
  double ConeAngle = 30.0;
  double Exponent = 1.0;
  ShadowKind Shadow = ShadowKind::None;
  double OpacityThreshold = 0.95;
  /// In the volume's own lengths. Empty: the smallest spacing.
  std::optional<double> ShadowBias;
};

enum class TechniqueChoice
{
  Auto,
  Rays,
  Volume,
  Map,
  DeepMap,
  OpacityMap
};

struct ShadowsDescription
{
  TechniqueChoice Technique = TechniqueChoice::Auto;
  /// In the volume's own lengths. Empty: twice the scene's sample distance.
  std::optional<double> SampleDistance;
  double Resolution = 1.0;
  /// Steps that are marched before what is kept counts.
  std::int64_t NearSteps = 4;
  double Tolerance = 1.0;
};

/// Keeps the side that the normal points to. In the world.
struct ClippingPlaneDescription
{
  Vector3 Origin = { 0.0, 0.0, 0.0 };
  Vector3 Normal = { 1.0, 0.0, 0.0 };
};

struct CameraDescription
{
  /// Empty: where the volume fits the picture.
  std::optional<Vector3> Position;
  /// Empty: the middle of the volume.
  std::optional<Vector3> FocalPoint;
  /// Empty: z, or y where the view is along z.
  std::optional<Vector3> ViewUp;
  /// Of the picture's height.
  double ViewAngle = 30.0;
  /// Half the picture's height in the world; makes the projection parallel.
  std::optional<double> ParallelScale;
};

struct ImageDescription
{
  std::array<int, 2> Size = { 512, 512 };
  Vector3 Background = { 0.0, 0.0, 0.0 };
};

enum class RendererChoice
{
  Penumbra,
  StockMapper,
  /// On the CPU, in double precision.
  Reference
};

struct SceneDescription
{
  VolumeDescription Volume;
  TransferFunctionDescription TransferFunction;
  /// Lights count in single scattering alone.
  OpticalModel Optics = OpticalModel::SingleScattering;
  MaterialDescription Material;
  GradientEstimator Gradient = GradientEstimator::CentralDifferences;
  /// Bits a component of gradients that are kept: 8 or 16. 0: they are estimated at each sample.
  /// Empty: the mapper chooses.
  std::optional<int> GradientTexture;
  std::vector<LightDescription> Lights = { DefaultLight() };
  bool TwoSidedLighting = true;
  ShadowsDescription Shadows;
  std::vector<ClippingPlaneDescription> ClippingPlanes;
  CameraDescription Camera;
  ImageDescription Image;
  /// In the volume's own lengths. Empty: half the smallest spacing.
  std::optional<double> SampleDistance;
  bool SkipEmptySpace = true;
  RendererChoice Renderer = RendererChoice::Penumbra;
  /// How much of its volumetric scattering the stock mapper takes, 0 to 2, see
  /// vtkGPUVolumeRayCastMapper::SetVolumetricScatteringBlending; it has it from VTK 9.2 on.
  double StockScattering = 0.0;

  /// What lights a scene without the key "lights".
  static LightDescription DefaultLight();
};

}

#endif
