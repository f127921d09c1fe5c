/**
 * @file    GradientOpacityTexture.h
 * @brief   a gradient opacity function as a texture
 */

#ifndef GradientOpacityTexture_h
#define GradientOpacityTexture_h

#include "GradientOpacityTable.h"
#include "LightingRequirements.h"
#include "VolumePlacement.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkVolumeProperty;

namespace penumbra
{

struct BrickVisibility;
struct ScalarRange;

class GradientOpacityTexture
{
public:
  /// Loads the property's function for a volume of this range and spacing, or drops the texture
  /// where the property has none.
  void Load(vtkOpenGLRenderWindow* window, vtkVolumeProperty* property, const ScalarRange& range,
    const double spacing[3], GradientEstimator estimator);
  /// Tells which bricks the function hides.
  void Describe(BrickVisibility& visibility) const;

  vtkTextureObject* GetTexture() const { return this->Texture; }
  /// scalarUnit: scalar units where the scalar texture holds 1.
  void SetUniforms(
    vtkShaderProgram* program, const VolumePlacement& placement, double scalarUnit) const;
  void Release(vtkOpenGLRenderWindow* window);

private:
  GradientOpacityTable Table;
  double BoundPerScalar = 0.0; ///< largest gradient of scalars that differ by 1
  vtkNew<vtkTextureObject> Texture;
};

}

#endif
