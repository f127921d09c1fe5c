#include "TransferFunctionTextures.h"

#include "MatrixUniforms.h"
#include "ScalarTexture.h"
#include "TextureSampling.h"

#include "vtkColorTransferFunction.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkShaderProgram.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace penumbra
{
namespace
{
constexpr int LargestTableSize = 8192;

TransferFunctions GetFunctions(
  vtkVolumeProperty* property, const ScalarTexture& scalars, const double spacing[3])
{
  TransferFunctions functions;
  functions.Opacity = property->GetScalarOpacity(0);
  if (property->GetColorChannels(0) == 3)
  {
    functions.Color = property->GetRGBTransferFunction(0);
  }
  else
  {
    functions.Gray = property->GetGrayTransferFunction(0);
  }
  functions.UnitDistance = property->GetScalarOpacityUnitDistance(0);
  functions.DataLow = scalars.GetRange().Low;
  functions.DataHigh = scalars.GetRange().High;
  functions.IntegerData = scalars.HoldsIntegers();
  functions.Step = std::min({ std::abs(spacing[0]), std::abs(spacing[1]), std::abs(spacing[2]) });
  return functions;
}

// Scale and offset from what the scalar texture returns to the coordinate of an even table whose
// first and last entries, at the centres of their texels, belong to low and high.
std::array<double, 2> GetTableCoordinate(
  double low, double high, size_t size, double scale, double offset)
{
  const double texels = static_cast<double>(size);
  const double perScalar = (texels - 1.0) / (texels * (high - low));
  return { perScalar * scale, (offset - low) * perScalar + 0.5 / texels };
}
}

//------------------------------------------------------------------------------
void TransferFunctionTextures::Load(vtkOpenGLRenderWindow* window, vtkVolumeProperty* property,
  const ScalarTexture& scalars, const double spacing[3])
{
  this->Table = MakeTransferFunctionTable(GetFunctions(property, scalars, spacing),
    std::min(LargestTableSize, vtkTextureObject::GetMaximumTextureSize(window)));
  this->Release(window);
  if (this->Table.Lookup == TransferFunctionLookup::Table || this->Table.Steep)
  {
    this->LoadTable(window);
  }
  if (this->Table.Lookup == TransferFunctionLookup::Points)
  {
    this->LoadPoints(window, scalars.GetEncoding().Scale);
  }
}

//------------------------------------------------------------------------------
void TransferFunctionTextures::LoadTable(vtkOpenGLRenderWindow* window)
{
  ResetTexture(this->Extinction, window, vtkTextureObject::Linear);
  ResetTexture(this->Color, window, vtkTextureObject::Linear);
  const int size = this->Table.GetSize();
  this->Color->Create1DFromRaw(size, 3, VTK_FLOAT, this->Table.Color.data());
  if (!this->Table.Steep)
  {
    this->Extinction->Create1DFromRaw(size, 1, VTK_FLOAT, this->Table.Extinction.data());
    return;
  }
  std::vector<float> extinction;
  for (int entry = 0; entry < size; ++entry)
  {
    extinction.push_back(this->Table.Extinction[entry]);
    extinction.push_back(this->Table.ExtinctionIntegral[entry]);
  }
  this->Extinction->Create1DFromRaw(size, 2, VTK_FLOAT, extinction.data());
  ResetTexture(this->ColorIntegral, window, vtkTextureObject::Linear);
  this->ColorIntegral->Create1DFromRaw(size, 3, VTK_FLOAT, this->Table.ColorIntegral.data());
}

//------------------------------------------------------------------------------
void TransferFunctionTextures::LoadPoints(vtkOpenGLRenderWindow* window, double scalarUnit)
{
  const int points = this->Table.GetNumberOfPoints();
  std::vector<float> rows(4 * static_cast<size_t>(points), 0.0f);
  for (int point = 0; point < points; ++point)
  {
    rows[4 * point] = static_cast<float>(this->Table.PointScalars[point] / scalarUnit);
  }
  rows.insert(rows.end(), this->Table.PointColors.begin(), this->Table.PointColors.end());
  ResetTexture(this->Points, window, vtkTextureObject::Nearest);
  this->Points->Create2DFromRaw(points, 2, 4, VTK_FLOAT, rows.data());
}

//------------------------------------------------------------------------------
int TransferFunctionTextures::GetLookupIterations() const
{
  if (this->Table.Lookup == TransferFunctionLookup::Table)
  {
    return 0;
  }
  return static_cast<int>(std::ceil(std::log2(std::max(this->Table.GetNumberOfPoints(), 2)))) + 1;
}

//------------------------------------------------------------------------------
std::array<vtkTextureObject*, 4> TransferFunctionTextures::GetTextures() const
{
  return { this->Extinction, this->Color, this->ColorIntegral, this->Points };
}

//------------------------------------------------------------------------------
void TransferFunctionTextures::SetUniforms(
  vtkShaderProgram* program, const ScalarEncoding& encoding, double unitDistance) const
{
  SetSampler(program, "scene_extinction", this->Extinction);
  SetSampler(program, "scene_color", this->Color);
  SetSampler(program, "scene_colorIntegral", this->ColorIntegral);
  SetSampler(program, "scene_points", this->Points);
  if (this->Extinction->GetHandle())
  {
    const auto coordinate = GetTableCoordinate(this->Table.Low, this->Table.High,
      this->Table.Extinction.size(), encoding.Scale, encoding.Offset);
    SetUniform(program, "scene_tableCoordinate", coordinate);
    this->SetIntegralUniforms(program);
  }
  if (this->Table.Lookup == TransferFunctionLookup::Points)
  {
    program->SetUniformi("scene_pointSearchSteps", this->GetLookupIterations());
    SetUniform(program, "scene_pointOffset", (this->Table.Low - encoding.Offset) / encoding.Scale);
    SetUniform(program, "scene_reciprocalUnitDistance", 1.0 / unitDistance);
  }
}

//------------------------------------------------------------------------------
void TransferFunctionTextures::SetIntegralUniforms(vtkShaderProgram* program) const
{
  const double entries = this->Table.GetSize();
  const std::array<double, 2> ends = { 0.5 / entries, 1.0 - 0.5 / entries };
  SetUniform(program, "scene_tableEnds", ends);
  // Two entries, each rounded in the table and once more in its interpolation. 0 would take
  // rounding for steepness where there is no matter at all.
  constexpr double rounding = 1.0 / (1 << 22);
  constexpr double tooRoughForColor = 1e-4;
  constexpr double least = 1e-30;
  const double whole = this->Table.ExtinctionIntegral.back();
  SetUniform(program, "scene_integralRounding", std::max(rounding * whole, least));
  SetUniform(program, "scene_colorIntegralLeast", std::max(tooRoughForColor * whole, least));
}

//------------------------------------------------------------------------------
void TransferFunctionTextures::Release(vtkOpenGLRenderWindow* window)
{
  for (vtkTextureObject* texture : this->GetTextures())
  {
    texture->ReleaseGraphicsResources(window);
  }
}

}
