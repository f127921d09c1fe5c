#include "ScalarTexture.h"

#include "vtkDataArray.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace penumbra
{
namespace
{
constexpr double LargestNormalized = 65535.0;

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

template <typename Scalar>
void EncodeNormalized(
  const Scalar* scalars, const ScalarEncoding& encoding, std::vector<unsigned short>& values)
{
  const double factor = LargestNormalized / encoding.Scale;
  vtkSMPTools::For(0, static_cast<vtkIdType>(values.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType voxel = begin; voxel < end; ++voxel)
      {
        const double value = (static_cast<double>(scalars[voxel]) - encoding.Offset) * factor;
        values[voxel] = static_cast<unsigned short>(value + 0.5);
      }
    });
}

template <typename Scalar>
void EncodeFloat(const Scalar* scalars, const ScalarEncoding& encoding, const ScalarRange& range,
  std::vector<float>& values)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(values.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType voxel = begin; voxel < end; ++voxel)
      {
        double value = static_cast<double>(scalars[voxel]);
        value = std::isnan(value) ? range.Low : std::clamp(value, range.Low, range.High);
        values[voxel] = static_cast<float>((value - encoding.Offset) / encoding.Scale);
      }
    });
}

void SetSampling(vtkTextureObject* texture, int filter)
{
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetWrapR(vtkTextureObject::ClampToEdge);
  texture->SetMinificationFilter(filter);
  texture->SetMagnificationFilter(filter);
}

bool Upload(vtkTextureObject* texture, vtkOpenGLRenderWindow* window,
  const std::array<int, 3>& dimensions, int type, void* values)
{
  texture->SetContext(window);
  texture->ResetFormatAndType();
  return texture->Create3DFromRaw(dimensions[0], dimensions[1], dimensions[2], 1, type, values);
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

//------------------------------------------------------------------------------
ScalarEncoding ChooseEncoding(int scalarType, const ScalarRange& range)
{
  switch (scalarType)
  {
    case VTK_UNSIGNED_CHAR:
      return { true, 255.0, 0.0 };
    case VTK_SIGNED_CHAR:
      return { true, 255.0, -128.0 };
    case VTK_UNSIGNED_SHORT:
      return { true, LargestNormalized, 0.0 };
    case VTK_SHORT:
      return { true, LargestNormalized, -32768.0 };
    default:
      break;
  }
  // Without an offset values near 0 keep digits of their own, which faint gradients need; with one,
  // values far from 0 keep those of their range.
  constexpr double farFromZero = 8.0;
  const double middle = 0.5 * range.Low + 0.5 * range.High;
  const double halfRange = 0.5 * range.High - 0.5 * range.Low;
  ScalarEncoding encoding;
  encoding.Offset = std::abs(middle) > farFromZero * halfRange ? middle : 0.0;
  // Floats overflow, or lose digits one by one, beyond these.
  constexpr double huge = 1e30;
  constexpr double tiny = 1e-20;
  const double magnitude =
    std::max(std::abs(range.Low - encoding.Offset), std::abs(range.High - encoding.Offset));
  if (magnitude > huge || (magnitude > 0.0 && magnitude < tiny))
  {
    encoding.Scale = magnitude;
  }
  return encoding;
}

//------------------------------------------------------------------------------
std::vector<unsigned short> EncodeNormalized(vtkDataArray* scalars, const ScalarEncoding& encoding)
{
  std::vector<unsigned short> values(scalars->GetNumberOfTuples());
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(
      EncodeNormalized(static_cast<VTK_TT*>(scalars->GetVoidPointer(0)), encoding, values));
  }
  return values;
}

//------------------------------------------------------------------------------
std::vector<float> EncodeFloat(
  vtkDataArray* scalars, const ScalarEncoding& encoding, const ScalarRange& range)
{
  std::vector<float> values(scalars->GetNumberOfTuples());
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(
      EncodeFloat(static_cast<VTK_TT*>(scalars->GetVoidPointer(0)), encoding, range, values));
  }
  return values;
}

//------------------------------------------------------------------------------
bool ScalarTexture::Load(
  vtkOpenGLRenderWindow* window, vtkDataArray* scalars, const std::array<int, 3>& dimensions)
{
  const int largest = vtkTextureObject::GetMaximumTextureSize3D(window);
  if (*std::max_element(dimensions.begin(), dimensions.end()) > largest)
  {
    return false;
  }
  this->Range = ComputeScalarRange(scalars);
  this->Encoding = ChooseEncoding(scalars->GetDataType(), this->Range);
  if (this->Encoding.Normalized)
  {
    std::vector<unsigned short> values = EncodeNormalized(scalars, this->Encoding);
    return Upload(this->Texture, window, dimensions, VTK_UNSIGNED_SHORT, values.data());
  }
  std::vector<float> values = EncodeFloat(scalars, this->Encoding, this->Range);
  return Upload(this->Texture, window, dimensions, VTK_FLOAT, values.data());
}

//------------------------------------------------------------------------------
void ScalarTexture::SetInterpolation(bool linear)
{
  SetSampling(this->Texture, linear ? vtkTextureObject::Linear : vtkTextureObject::Nearest);
}

//------------------------------------------------------------------------------
void ScalarTexture::Release(vtkOpenGLRenderWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
bool LoadMask(vtkTextureObject* texture, vtkOpenGLRenderWindow* window, vtkDataArray* mask,
  const std::array<int, 3>& dimensions)
{
  std::vector<unsigned char> values(mask->GetNumberOfTuples());
  vtkSMPTools::For(0, mask->GetNumberOfTuples(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType voxel = begin; voxel < end; ++voxel)
      {
        values[voxel] = mask->GetComponent(voxel, 0) != 0.0 ? 255 : 0;
      }
    });
  const bool loaded = Upload(texture, window, dimensions, VTK_UNSIGNED_CHAR, values.data());
  SetSampling(texture, vtkTextureObject::Nearest);
  return loaded;
}

}
