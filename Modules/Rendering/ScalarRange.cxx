#include "ScalarRange.h"

#include "vtkDataArray.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace penumbra
{
namespace
{
template <typename Scalar>
struct FiniteRange
{
  const Scalar* Scalars;
  vtkSMPThreadLocal<ScalarRange> Local;
  ScalarRange Result;

  void Initialize() { this->Local.Local() = MakeEmpty(); }
  static ScalarRange MakeEmpty()
  {
    const double infinity = std::numeric_limits<double>::infinity();
    return { infinity, -infinity, true };
  }
  void operator()(vtkIdType begin, vtkIdType end)
  {
    ScalarRange& range = this->Local.Local();
    for (vtkIdType voxel = begin; voxel < end; ++voxel)
    {
      const double value = static_cast<double>(this->Scalars[voxel]);
      if (std::isfinite(value))
      {
        range.Low = std::min(range.Low, value);
        range.High = std::max(range.High, value);
      }
      else
      {
        range.AllFinite = false;
      }
    }
  }
  void Reduce()
  {
    this->Result = MakeEmpty();
    for (const ScalarRange& range : this->Local)
    {
      this->Result.Low = std::min(this->Result.Low, range.Low);
      this->Result.High = std::max(this->Result.High, range.High);
      this->Result.AllFinite = this->Result.AllFinite && range.AllFinite;
    }
  }
};

template <typename Scalar>
ScalarRange FindFiniteRange(const Scalar* scalars, vtkIdType count)
{
  FiniteRange<Scalar> finder;
  finder.Scalars = scalars;
  vtkSMPTools::For(0, count, finder);
  return finder.Result;
}
}

//------------------------------------------------------------------------------
ScalarRange ComputeScalarRange(vtkDataArray* scalars)
{
  ScalarRange range;
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(range = FindFiniteRange(static_cast<VTK_TT*>(scalars->GetVoidPointer(0)),
                       scalars->GetNumberOfTuples()));
  }
  if (range.Low > range.High)
  {
    range.Low = range.High = 0.0;
  }
  return range;
}

}
