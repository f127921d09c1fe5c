/**
 * @file    EmptySpace.h
 * @brief   which bricks of a volume may hold visible matter, and how far around them none does
 *
 * For each of the eight octants of directions, each brick knows the edge of the largest cube of
 * empty bricks that begins at it and lies ahead of it: so far may any ray of that octant leap
 * (after the distance maps of Cohen and Sheffer 1994; a ray that leaves matter has no matter ahead,
 * however near it is behind). What lies outside the volume counts as empty.
 */

#ifndef EmptySpace_h
#define EmptySpace_h

#include "PenumbraRenderingModule.h" // For export macro
#include "ScalarBricks.h"
#include "VolumePlacement.h"

#include <array>
#include <vector>

namespace penumbra
{

class VisibleScalars;

/// vtkVolumeMapper's cropping to regions, its planes in voxel indices.
struct CroppedRegions
{
  bool On = false;
  int Flags = 0;
  std::array<double, 3> Low{};
  std::array<double, 3> High{};

  bool operator==(const CroppedRegions& other) const
  {
    return this->On == other.On && this->Flags == other.Flags && this->Low == other.Low &&
      this->High == other.High;
  }
};

/// What hides or shows bricks beside the opacity function.
struct BrickVisibility
{
  /// Magnitudes below it have no gradient opacity, and no gradient of a brick is larger than
  /// GradientBound times the difference of the scalars of it and its neighbours. 0: any magnitude
  /// shows.
  double LeastGradient = 0.0;
  double GradientBound = 0.0;
  CroppedRegions Regions;
  /// From FindShownBricks; empty: no mask.
  std::vector<unsigned char> ShownByMask;
};

/// 1 for each brick that may hold visible matter.
PENUMBRARENDERING_EXPORT std::vector<unsigned char> FindOccupiedBricks(
  const ScalarBricks& bricks, const VisibleScalars& visible, const BrickVisibility& visibility);

/// The smallest box of bricks around the occupied ones. None occupied: of no brick, its Last before
/// its First.
struct BrickBox
{
  std::array<int, 3> First{};
  std::array<int, 3> Last{ -1, -1, -1 };
};

PENUMBRARENDERING_EXPORT BrickBox FindBoxOfOccupied(
  const std::vector<unsigned char>& occupied, const BrickGrid& grid);

/// The occupied bricks that a ray may meet first: those with an empty one, or none, across one of
/// their faces.
PENUMBRARENDERING_EXPORT std::vector<int> FindOuterBricks(
  const std::vector<unsigned char>& occupied, const BrickGrid& grid);

/// Scale and offset from texture coordinates to bricks.
struct BrickMap
{
  Vector3 Scale{};
  Vector3 Offset{};
};

PENUMBRARENDERING_EXPORT BrickMap MapToBricks(const BrickGrid& grid);

/// In texture coordinates.
struct TextureBox
{
  Vector3 Low{ 0.0, 0.0, 0.0 };
  Vector3 High{ 1.0, 1.0, 1.0 };
};

/// Where bricks lie; the outer ones reach to the volume's faces. Of no brick: the whole volume.
PENUMBRARENDERING_EXPORT TextureBox PlaceBricks(const BrickBox& bricks, const BrickGrid& grid);

/// Edges of the cubes in bricks, at most 255; 0 for an occupied brick. One volume of bricks an
/// octant, x fastest; bits 0, 1 and 2 of the octant stand for directions of falling x, y and z.
PENUMBRARENDERING_EXPORT std::vector<unsigned char> ComputeEmptyCubes(
  const std::vector<unsigned char>& occupied, const BrickGrid& grid);

}

#endif
