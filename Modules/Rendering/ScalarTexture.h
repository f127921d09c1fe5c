/**
 * @file    ScalarTexture.h
 * @brief   a volume's scalars, and its mask, as 3D textures
 *
 * Scalars of 8 and 16 bits become 16-bit normalized values, all others floats: some drivers filter
 * 8-bit textures with 8 bits, which shows under steep transfer functions. Floats are stored
 * relative to an offset where the data's values are large against their range, and divided by a
 * scale where they are beyond single precision. NaN and -Inf count as the smallest finite value,
 * +Inf as the largest.
 */

#ifndef ScalarTexture_h
#define ScalarTexture_h

#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <array>
#include <vector>

class vtkDataArray;
class vtkOpenGLRenderWindow;

namespace penumbra
{

/// The affine map between scalars and what a texture of them returns: scalar = Scale * value +
/// Offset.
struct ScalarEncoding
{
  bool Normalized = false; ///< 16-bit normalized values; else floats
  double Scale = 1.0;
  double Offset = 0.0;
};

/// Smallest and largest finite value of an array's first component, and whether all are finite.
struct ScalarRange
{
  double Low = 0.0;
  double High = 0.0;
  bool AllFinite = true;
};

ScalarRange ComputeScalarRange(vtkDataArray* scalars);
ScalarEncoding ChooseEncoding(int scalarType, const ScalarRange& range);

/// Values for a texture of that encoding, one a voxel.
std::vector<unsigned short> EncodeNormalized(vtkDataArray* scalars, const ScalarEncoding& encoding);
std::vector<float> EncodeFloat(
  vtkDataArray* scalars, const ScalarEncoding& encoding, const ScalarRange& range);

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

private:
  vtkNew<vtkTextureObject> Texture;
  ScalarEncoding Encoding;
  ScalarRange Range;
};

/// Loads a mask: 0 hides, all else shows.
bool LoadMask(vtkTextureObject* texture, vtkOpenGLRenderWindow* window, vtkDataArray* mask,
  const std::array<int, 3>& dimensions);

}

#endif
