/**
 * @file    GradientTexture.h
 * @brief   a volume's gradients as a texture, made once per volume and estimator
 */

#ifndef GradientTexture_h
#define GradientTexture_h

#include "LightingRequirements.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"
#include "vtkTimeStamp.h"

#include <array>
#include <cstddef>

class vtkDataArray;
class vtkOpenGLRenderWindow;

namespace penumbra
{

struct ScalarRange;

/// What keeping gradients costs, see QuantizedGradientField.
struct GradientTextureReport
{
  int Bits = 0; ///< a component; 0 where gradients are not kept
  std::size_t Bytes = 0;
  double LargestError = 0.0;
  double MeanAngularError = 0.0;
};

class GradientTexture
{
public:
  /// Makes and loads the gradients, unless they are there already; exact ones
  /// (GradientDifferences.h) of 16 bits, where range says that they are. False where the graphics
  /// card cannot hold them. time: when the scalars or their place last changed.
  bool Update(vtkOpenGLRenderWindow* window, vtkDataArray* scalars,
    const std::array<int, 3>& dimensions, const ScalarRange& range, vtkMTimeType time,
    GradientEstimator estimator, int bits);
  void SetInterpolation(bool linear);

  const GradientTextureReport& GetReport() const { return this->Report; }
  /// Differences of the scalar per voxel where the texture holds 1.
  double GetScale() const { return this->Scale; }
  vtkTextureObject* GetTexture() const { return this->Texture; }
  void Release(vtkOpenGLRenderWindow* window);

private:
  bool LoadDifferences(
    vtkDataArray* scalars, const std::array<int, 3>& dimensions, GradientEstimator estimator);
  bool LoadQuantized(vtkDataArray* scalars, const std::array<int, 3>& dimensions,
    GradientEstimator estimator, int bits);
  bool Load(const std::array<int, 3>& dimensions, int bits, void* values);

  vtkNew<vtkTextureObject> Texture;
  vtkTimeStamp LoadTime;
  vtkDataArray* LoadedScalars = nullptr;
  GradientEstimator LoadedEstimator = GradientEstimator::CentralDifferences;
  GradientTextureReport Report;
  double Scale = 0.0;
  int Filter = vtkTextureObject::Linear;
};

}

#endif
