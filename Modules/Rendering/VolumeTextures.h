/**
 * @file    VolumeTextures.h
 * @brief   all textures of one volume, loaded again only when what they hold has changed
 */

#ifndef VolumeTextures_h
#define VolumeTextures_h

#include "EmptySpaceTexture.h"
#include "GradientOpacityTexture.h"
#include "GradientTexture.h"
#include "MaskTexture.h"
#include "ScalarTexture.h"
#include "TransferFunctionTextures.h"
#include "ViewTiles.h"
#include "VolumePlacement.h"

#include "vtkTimeStamp.h"

#include <array>
#include <vector>

class vtkDataArray;
class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkVolumeProperty;

namespace penumbra
{

class VolumeTextures
{
public:
  /// Loads the volume's scalars. False where the graphics card cannot hold them.
  bool UpdateScalars(vtkOpenGLRenderWindow* window, vtkImageData* image, vtkDataArray* scalars);
  void SetInterpolation(bool linear);
  /// Loads the mask, or drops it where it is null. False where the graphics card cannot hold it.
  bool UpdateMask(vtkOpenGLRenderWindow* window, vtkImageData* mask)
  {
    return this->Mask.Update(window, mask);
  }
  void UpdateTransferFunctions(
    vtkOpenGLRenderWindow* window, vtkVolumeProperty* property, GradientEstimator estimator);
  /// 16 where so many bits a component hold the gradients of the scalars that are loaded exactly
  /// and take little memory; else 0.
  int ChooseGradientBits(GradientEstimator estimator) const;
  /// Keeps the gradients of the scalars that are loaded, bits of 8 or 16 a component, or drops them
  /// where bits is 0. False where the graphics card cannot hold them.
  bool UpdateGradients(vtkOpenGLRenderWindow* window, GradientEstimator estimator, int bits);

  /// Finds bricks without visible matter. Returns whether leaping over them helps.
  bool UpdateEmptySpace(vtkOpenGLRenderWindow* window, const CroppedRegions& regions);
  void DropEmptySpace(vtkOpenGLRenderWindow* window);

  bool HasNonFiniteScalars() const { return !this->Scalars.GetRange().AllFinite; }
  vtkMTimeType GetScalarsTime() const { return this->ScalarsTime.GetMTime(); }
  vtkMTimeType GetMaskTime() const { return this->Mask.GetTime(); }
  bool HasMask() const { return this->Mask.GetMask() != nullptr; }
  const TransferFunctionTextures& GetTransferFunctions() const { return this->TransferFunctions; }
  const EmptySpaceReport& GetEmptySpaceReport() const { return this->EmptySpace.GetReport(); }
  /// The parts of a picture that visible matter is seen in.
  ViewTiles FindViewTiles(const Matrix4& textureToClip, int width, int height) const
  {
    return penumbra::FindViewTiles(
      this->EmptySpace.GetOuterBricks(), this->EmptySpace.GetGrid(), textureToClip, width, height);
  }
  const GradientTextureReport& GetGradientReport() const { return this->Gradients.GetReport(); }
  /// Scalar units where the scalar texture holds 1.
  double GetScalarUnit() const { return this->Scalars.GetEncoding().Scale; }
  /// Standard deviation of the scalars' noise, found when it is first asked for.
  double GetNoise();

  void Activate();
  void Deactivate();
  void SetUniforms(
    vtkShaderProgram* program, const VolumePlacement& placement, double unitDistance) const;

  void Release(vtkOpenGLRenderWindow* window);

private:
  std::vector<vtkTextureObject*> GetLoaded() const;

  ScalarTexture Scalars;
  vtkTimeStamp ScalarsTime;
  vtkDataArray* LoadedScalars = nullptr;
  vtkImageData* LoadedImage = nullptr;
  std::array<int, 3> LoadedDimensions{};
  GradientTexture Gradients;
  EmptySpaceTexture EmptySpace;
  vtkTimeStamp EmptySpaceTime;
  CroppedRegions LoadedRegions;
  double Noise = 0.0;
  vtkTimeStamp NoiseTime;

  MaskTexture Mask;

  TransferFunctionTextures TransferFunctions;
  GradientOpacityTexture GradientOpacity;
  vtkTimeStamp TransferFunctionTime;
  vtkVolumeProperty* LoadedProperty = nullptr;
  GradientEstimator LoadedEstimator = GradientEstimator::CentralDifferences;
};

}

#endif
