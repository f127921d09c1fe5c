/**
 * @file    GridWalk.h
 * @brief   the blocks of a regular grid that a ray passes, from one exact face to the next
 */

#ifndef GridWalk_h
#define GridWalk_h

#include "VolumeRay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace penumbra::reference
{

/// Blocks are `size` cells long along each axis, and counted from 0 to `counts` - 1; the outermost
/// ones have no end outwards.
class GridWalk
{
public:
  GridWalk(
    const VolumeRay& ray, double begin, double end, int size, const std::array<int, 3>& counts)
    : Ray(ray)
    , Finish(end)
    , Size(size)
    , Counts(counts)
    , BeginOfBlock(begin)
  {
    const vtkVector3d start = ray.At(begin);
    for (int axis = 0; axis < 3; ++axis)
    {
      const double block = std::clamp(std::floor(start[axis] / size), 0.0, counts[axis] - 1.0);
      this->Position[axis] = static_cast<int>(block);
      this->SetNextFace(axis);
    }
    this->SetEnd();
  }

  bool IsFinished() const { return this->BeginOfBlock >= this->Finish; }
  const std::array<int, 3>& GetBlock() const { return this->Position; }
  double GetBegin() const { return this->BeginOfBlock; }
  double GetEnd() const { return this->EndOfBlock; }

  void Next()
  {
    this->BeginOfBlock = this->EndOfBlock;
    this->Position[this->NearestAxis] += this->Ray.Direction[this->NearestAxis] > 0.0 ? 1 : -1;
    this->SetNextFace(this->NearestAxis);
    this->SetEnd();
  }

private:
  void SetNextFace(int axis)
  {
    const double direction = this->Ray.Direction[axis];
    const int face = this->Position[axis] + (direction > 0.0 ? 1 : 0);
    const bool isInner = direction != 0.0 && face > 0 && face < this->Counts[axis];
    this->NextFace[axis] = isInner
      ? (static_cast<double>(face) * this->Size - this->Ray.Start[axis]) / direction
      : std::numeric_limits<double>::infinity();
  }

  void SetEnd()
  {
    this->NearestAxis = static_cast<int>(
      std::min_element(this->NextFace.begin(), this->NextFace.end()) - this->NextFace.begin());
    this->EndOfBlock =
      std::clamp(this->NextFace[this->NearestAxis], this->BeginOfBlock, this->Finish);
  }

  const VolumeRay& Ray;
  double Finish;
  int Size;
  std::array<int, 3> Counts;
  std::array<int, 3> Position{};
  std::array<double, 3> NextFace{};
  int NearestAxis = 0;
  double BeginOfBlock;
  double EndOfBlock = 0.0;
};

}

#endif
