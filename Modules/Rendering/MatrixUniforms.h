/**
 * @file    MatrixUniforms.h
 * @brief   values in double precision to the floats of a shader's uniforms, and textures
 *
 * Uniforms that the program does not use are passed over.
 */

#ifndef MatrixUniforms_h
#define MatrixUniforms_h

#include "VolumePlacement.h"

#include <array>

class vtkShaderProgram;
class vtkTextureObject;

namespace penumbra
{

void SetUniform(vtkShaderProgram* program, const char* name, double value);
void SetUniform(vtkShaderProgram* program, const char* name, const std::array<double, 2>& vector);
void SetUniform(vtkShaderProgram* program, const char* name, const Vector3& vector);
void SetUniform(vtkShaderProgram* program, const char* name, const std::array<double, 4>& vector);
void SetUniform(vtkShaderProgram* program, const char* name, const Matrix3& matrix);
void SetUniform(vtkShaderProgram* program, const char* name, const Matrix4& matrix);
/// The unit that the texture is bound to, where the program has such a sampler.
void SetSampler(vtkShaderProgram* program, const char* name, vtkTextureObject* texture);

}

#endif
