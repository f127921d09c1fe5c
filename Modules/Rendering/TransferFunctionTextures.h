/**
 * @file    TransferFunctionTextures.h
 * @brief   opacity and colour as textures: tables, their integrals, or points
 */

#ifndef TransferFunctionTextures_h
#define TransferFunctionTextures_h

#include "TransferFunctionTable.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <array>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkVolumeProperty;

namespace penumbra
{

struct ScalarEncoding;
class ScalarTexture;

class TransferFunctionTextures
{
public:
  /// Loads the functions of a property for a volume of these scalars and this spacing.
  void Load(vtkOpenGLRenderWindow* window, vtkVolumeProperty* property,
    const ScalarTexture& scalars, const double spacing[3]);
  bool IsLoaded() const { return this->Extinction->GetHandle() || this->Points->GetHandle(); }

  const TransferFunctionTable& GetTable() const { return this->Table; }
  /// Halvings that a search among the points takes; 0 for a table.
  int GetLookupIterations() const;

  std::array<vtkTextureObject*, 4> GetTextures() const;
  void SetUniforms(
    vtkShaderProgram* program, const ScalarEncoding& encoding, double unitDistance) const;
  void Release(vtkOpenGLRenderWindow* window);

private:
  void LoadTable(vtkOpenGLRenderWindow* window);
  void LoadPoints(vtkOpenGLRenderWindow* window, double scalarUnit);
  void SetIntegralUniforms(vtkShaderProgram* program) const;

  TransferFunctionTable Table;
  vtkNew<vtkTextureObject> Extinction;
  vtkNew<vtkTextureObject> Color;
  vtkNew<vtkTextureObject> ColorIntegral;
  vtkNew<vtkTextureObject> Points;
};

}

#endif
