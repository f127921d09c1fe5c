/**
 * @file    RadianceIntegral.h
 * @brief   what one view ray brings to the eye, and how far that may be from the truth
 */

#ifndef RadianceIntegral_h
#define RadianceIntegral_h

#include "RadianceTerm.h"

#include <optional>
#include <queue>
#include <vector>

namespace penumbra::reference
{

struct RayRadiance
{
  /// Without what is behind the volume.
  Rgb Radiance{};
  double Transmittance = 1.0;
  /// Bound on the error of any channel.
  double Error = 0.0;
  bool Converged = true;
  int Samples = 0;
  int ShadowRays = 0;
};

/**
 * The sum of the terms of a ray's segments. Each begins with few samples; then the one with the
 * largest error goes first and gets more, or is halved, until the sum of all errors is below the
 * tolerance. A segment in which a hard shadow begins or ends is divided there.
 */
class RadianceIntegral
{
public:
  /// `toEye` is in the world, of unit length.
  RadianceIntegral(const RenderingModel& model, const VolumeRay& ray, const vtkVector3d& toEye);

  RayRadiance Compute();

private:
  struct ByError
  {
    double Error;
    std::size_t Number;
    bool operator<(const ByError& other) const { return this->Error < other.Error; }
  };

  ShadedSample ComputeSample(const RaySegment& segment, double u);
  void SumCoarsely(RadianceTerm& term);
  void SumFinely(RadianceTerm& term);
  void Refine(std::size_t number);
  void Divide(std::size_t number, double u);
  /// Until no shadow's edge is known within the term or what it was divided into.
  void DivideAtShadowEdges(std::size_t number);
  std::optional<double> FindShadowEdge(const RadianceTerm& term);
  std::optional<double> FindShadowEdge(const RadianceTerm& term, int shadow);
  double GetResolution(const RaySegment& segment) const;
  void Enqueue(std::size_t number);
  double GetTotalError() const;
  RayRadiance GetSum() const;

  const RenderingModel& Model;
  vtkVector3d ToEye;
  RaySegments Segments;
  int HardShadows;
  std::vector<RadianceTerm> Terms;
  std::priority_queue<ByError> Queue;
  Rgb ErrorSum{};
  int SampleCount = 0;
  int ShadowRayCount = 0;
};

}

#endif
