/**
 * @file    ScalarTexture.h
 * @brief   a volume's scalars as a 3D texture, encoded as ScalarEncoding.h says
 */

#ifndef ScalarTexture_h
#define ScalarTexture_h

#include "ScalarEncoding.h"
#include "ScalarRange.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <array>

class vtkDataArray;
class vtkOpenGLRenderWindow;

namespace penumbra
{

class ScalarTexture
{
public:
  /// Makes the texture anew. False where the graphics card cannot hold it.
  bool Load(
    vtkOpenGLRenderWindow* window, vtkDataArray* scalars, const std::array<int, 3>& dimensions);
  void SetInterpolation(bool linear);
  void Release(vtkOpenGLRenderWindow* window);

  vtkTextureObject* GetTexture() const { return this->Texture; }
  const ScalarEncoding& GetEncoding() const { return this->Encoding; }
  const ScalarRange& GetRange() const { return this->Range; }
  /// Whether the scalars are of an integer type.
  bool HoldsIntegers() const { return this->Integers; }

private:
  vtkNew<vtkTextureObject> Texture;
  ScalarEncoding Encoding;
  ScalarRange Range;
  bool Integers = false;
};

}

#endif
