#include "MatrixUniforms.h"

#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

namespace penumbra
{
namespace
{
template <size_t Size>
std::array<float, Size> ToFloat(const std::array<double, Size>& values)
{
  std::array<float, Size> result;
  for (size_t i = 0; i < Size; ++i)
  {
    result[i] = static_cast<float>(values[i]);
  }
  return result;
}

// OpenGL takes matrices column by column.
template <int Order>
std::array<float, Order * Order> ToColumns(const std::array<double, Order * Order>& matrix)
{
  std::array<float, Order * Order> columns;
  for (int row = 0; row < Order; ++row)
  {
    for (int column = 0; column < Order; ++column)
    {
      columns[Order * column + row] = static_cast<float>(matrix[Order * row + column]);
    }
  }
  return columns;
}
}

//------------------------------------------------------------------------------
void SetUniform(vtkShaderProgram* program, const char* name, double value)
{
  if (program->IsUniformUsed(name))
  {
    program->SetUniformf(name, static_cast<float>(value));
  }
}

//------------------------------------------------------------------------------
void SetUniform(vtkShaderProgram* program, const char* name, const std::array<double, 2>& vector)
{
  if (program->IsUniformUsed(name))
  {
    program->SetUniform2f(name, ToFloat(vector).data());
  }
}

//------------------------------------------------------------------------------
void SetUniform(vtkShaderProgram* program, const char* name, const Vector3& vector)
{
  if (program->IsUniformUsed(name))
  {
    program->SetUniform3f(name, ToFloat(vector).data());
  }
}

//------------------------------------------------------------------------------
void SetUniform(vtkShaderProgram* program, const char* name, const std::array<double, 4>& vector)
{
  if (program->IsUniformUsed(name))
  {
    program->SetUniform4f(name, ToFloat(vector).data());
  }
}

//------------------------------------------------------------------------------
void SetUniform(vtkShaderProgram* program, const char* name, const Matrix3& matrix)
{
  if (program->IsUniformUsed(name))
  {
    auto columns = ToColumns<3>(matrix);
    program->SetUniformMatrix3x3(name, columns.data());
  }
}

//------------------------------------------------------------------------------
void SetUniform(vtkShaderProgram* program, const char* name, const Matrix4& matrix)
{
  if (program->IsUniformUsed(name))
  {
    auto columns = ToColumns<4>(matrix);
    program->SetUniformMatrix4x4(name, columns.data());
  }
}

//------------------------------------------------------------------------------
void SetSampler(vtkShaderProgram* program, const char* name, vtkTextureObject* texture)
{
  if (program->IsUniformUsed(name))
  {
    program->SetUniformi(name, texture->GetTextureUnit());
  }
}

}
