/**
 * @file    VolumeMatter.h
 * @brief   everything about a volume that light meets on its way
 */

#ifndef VolumeMatter_h
#define VolumeMatter_h

#include "OccupiedCells.h"
#include "PiecewiseLinear.h"
#include "Polynomial.h"
#include "ScalarField.h"
#include "TransferFunctions.h"
#include "VisibleRegion.h"
#include "VolumeFrame.h"

#include <array>
#include <optional>
#include <vector>

namespace penumbra::reference
{

/// What of a ray is within one cell, in the parameter u from 0 to 1.
struct CellSpan
{
  /// In the ray's parameter.
  double Begin = 0.0;
  double End = 0.0;
  VoxelIndex Cell{};
  /// In the cell's own coordinates.
  vtkVector3d Start;
  vtkVector3d Step;
  Cubic Scalar;

  double GetLength() const { return this->End - this->Begin; }
};

/// In scalar units per voxel, along a span.
using SpanGradient = std::array<Cubic, 3>;

class VolumeMatter
{
public:
  explicit VolumeMatter(const ReferenceScene& scene);

  const VolumeFrame& GetFrame() const { return this->Frame; }
  const ScalarField& GetField() const { return this->Field; }
  const VisibleRegion& GetRegion() const { return this->Region; }
  const ExtinctionFunction& GetExtinction() const { return this->Extinction; }
  const OccupiedCells& GetOccupied() const { return this->Occupied; }

  /// Factor of the extinction by the gradient's magnitude in scalar units per mean voxel, or null.
  const PiecewiseLinear<1>* GetGradientOpacity() const
  {
    return this->GradientOpacity ? &*this->GradientOpacity : nullptr;
  }
  /// The squares of that function's levels.
  const std::vector<double>& GetSquaredGradientLevels() const { return this->SquaredLevels; }

  /// Whether the field changes in the middle between voxels: its value or what the mask says.
  bool HasVoxelFaces() const { return this->Nearest || this->Region.HasMask(); }

  /// Fills in the scalar field along the span. False where the mask hides it.
  bool FillSpan(CellSpan& span) const;
  SpanGradient GetGradient(const CellSpan& span) const;
  /// Of the magnitude in scalar units per mean voxel.
  Polynomial<6> GetSquaredGradient(const SpanGradient& gradient) const;

private:
  VoxelIndex GetNearestVoxel(const CellSpan& span) const;

  VolumeFrame Frame;
  ScalarField Field;
  VisibleRegion Region;
  ExtinctionFunction Extinction;
  std::optional<PiecewiseLinear<1>> GradientOpacity;
  std::vector<double> SquaredLevels;
  OccupiedCells Occupied;
  GradientEstimator Estimator;
  bool Nearest;
};

}

#endif
