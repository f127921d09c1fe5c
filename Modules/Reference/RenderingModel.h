/**
 * @file    RenderingModel.h
 * @brief   a scene as its view rays see it
 */

#ifndef RenderingModel_h
#define RenderingModel_h

#include "Illumination.h"
#include "PiecewiseLinear.h"
#include "VolumeMatter.h"

#include <optional>

namespace penumbra::reference
{

/// Shares of the tolerance of a pixel, in parts of the whole.
constexpr double ShadowShare = 0.1;
constexpr double DepthShare = 0.05;
/// What may be left of the transmittance where a ray ends.
constexpr double RemainderShare = 0.05;

struct RenderingModel
{
  /// `tolerance` is of a pixel's channels, of which 1 is white.
  RenderingModel(const ReferenceScene& scene, double tolerance, int mostSamples);

  bool IsLit() const { return this->Optics == OpticalModel::SingleScattering; }
  bool HasColors() const { return this->Optics != OpticalModel::Absorption; }
  bool Absorbs() const { return this->Optics != OpticalModel::Emission; }

  /// Of a sample seen: lit, or the transfer function's own colour.
  ShadedSample Shade(const MatterSample& sample) const;

  VolumeMatter Matter;
  PiecewiseLinear<3> Colors;
  OpticalModel Optics;
  double Tolerance;
  int MostSamples;
  std::optional<Illumination> Lighting;
};

}

#endif
