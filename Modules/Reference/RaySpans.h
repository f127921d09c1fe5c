/**
 * @file    RaySpans.h
 * @brief   a ray through matter, cell by cell
 */

#ifndef RaySpans_h
#define RaySpans_h

#include "GridWalk.h"
#include "VolumeMatter.h"

namespace penumbra::reference
{

template <typename Visitor>
class SpanVisit
{
public:
  SpanVisit(const VolumeMatter& matter, const VolumeRay& ray, Visitor& visit)
    : Matter(matter)
    , Ray(ray)
    , Visit(visit)
  {
  }

  bool VisitBricks()
  {
    const OccupiedCells& occupied = this->Matter.GetOccupied();
    GridWalk bricks(
      this->Ray, 0.0, this->Ray.Length, OccupiedCells::BrickSize, occupied.GetBrickCounts());
    for (; !bricks.IsFinished(); bricks.Next())
    {
      if (occupied.IsBrickOccupied(bricks.GetBlock()) &&
        !this->VisitCells(bricks.GetBegin(), bricks.GetEnd()))
      {
        return false;
      }
    }
    return true;
  }

private:
  bool VisitCells(double begin, double end)
  {
    const OccupiedCells& occupied = this->Matter.GetOccupied();
    GridWalk cells(this->Ray, begin, end, 1, occupied.GetCounts());
    for (; !cells.IsFinished(); cells.Next())
    {
      if (occupied.IsOccupied(cells.GetBlock()))
      {
        CellSpan span;
        span.Cell = cells.GetBlock();
        if (this->Matter.HasVoxelFaces()
            ? !this->VisitVoxels(span, cells.GetBegin(), cells.GetEnd())
            : !this->VisitSpan(span, cells.GetBegin(), cells.GetEnd()))
        {
          return false;
        }
      }
    }
    return true;
  }

  /// From one face between voxels, halfway through the cell, to the next.
  bool VisitVoxels(CellSpan& span, double begin, double end)
  {
    std::array<double, 4> ends;
    ends.fill(end);
    for (int axis = 0; axis < 3; ++axis)
    {
      const double face =
        (span.Cell[axis] + 0.5 - this->Ray.Start[axis]) / this->Ray.Direction[axis];
      if (face > begin && face < end)
      {
        ends[axis] = face;
      }
    }
    std::sort(ends.begin(), ends.end());
    for (const double next : ends)
    {
      if (!this->VisitSpan(span, begin, next))
      {
        return false;
      }
      begin = next;
    }
    return true;
  }

  bool VisitSpan(CellSpan& span, double begin, double end)
  {
    if (end <= begin)
    {
      return true;
    }
    span.Begin = begin;
    span.End = end;
    span.Start = this->Ray.At(begin) - vtkVector3d(span.Cell[0], span.Cell[1], span.Cell[2]);
    span.Step = this->Ray.Direction * (end - begin);
    return !this->Matter.FillSpan(span) || this->Visit(span);
  }

  const VolumeMatter& Matter;
  const VolumeRay& Ray;
  Visitor& Visit;
};

/// Calls visit(CellSpan) for what of the ray can have extinction, front to back, until it returns
/// false. The ray is within the volume.
template <typename Visitor>
void VisitSpans(const VolumeMatter& matter, const VolumeRay& ray, Visitor visit)
{
  SpanVisit<Visitor>(matter, ray, visit).VisitBricks();
}

}

#endif
