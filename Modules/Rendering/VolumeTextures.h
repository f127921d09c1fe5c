/**
 * @file    VolumeTextures.h
 * @brief   all textures of one volume, loaded again only when what they hold has changed
 */

#ifndef VolumeTextures_h
#define VolumeTextures_h

#include "EmptySpaceTexture.h"
#include "GradientTexture.h"
#include "ScalarTexture.h"
#include "TransferFunctionTable.h"
#include "VolumePlacement.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"
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
  /// Loads the mask, or drops it where it is null.
  bool UpdateMask(vtkOpenGLRenderWindow* window, vtkImageData* mask);
  void UpdateTransferFunctions(
    vtkOpenGLRenderWindow* window, vtkVolumeProperty* property, GradientEstimator estimator);
  /// Keeps the gradients of the scalars that are loaded, bits of 8 or 16 a component, or drops them
  /// where bits is 0. False where the graphics card cannot hold them.
  bool UpdateGradients(vtkOpenGLRenderWindow* window, GradientEstimator estimator, int bits);

  /// Finds bricks without visible matter. Returns whether leaping over them helps.
  bool UpdateEmptySpace(vtkOpenGLRenderWindow* window, const CroppedRegions& regions);
  void DropEmptySpace(vtkOpenGLRenderWindow* window);

  bool HasNonFiniteScalars() const { return !this->Scalars.GetRange().AllFinite; }
  vtkMTimeType GetScalarsTime() const { return this->ScalarsTime.GetMTime(); }
  vtkMTimeType GetMaskTime() const { return this->MaskTime.GetMTime(); }
  bool HasMask() const { return this->LoadedMask != nullptr; }
  bool AreTransferFunctionsAccurate() const { return this->Table.Accurate; }
  TransferFunctionLookup GetLookup() const { return this->Table.Lookup; }
  bool AreTransferFunctionsSteep() const { return this->Table.Steep; }
  /// Halvings that a search among the points takes; 0 for a table.
  int GetLookupIterations() const;
  const EmptySpaceReport& GetEmptySpaceReport() const { return this->EmptySpace.GetReport(); }
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
  void LoadTable(vtkOpenGLRenderWindow* window);
  void LoadPoints(vtkOpenGLRenderWindow* window);
  void LoadGradientOpacity(
    vtkOpenGLRenderWindow* window, vtkVolumeProperty* property, GradientEstimator estimator);
  void SetIntegralUniforms(vtkShaderProgram* program) const;
  std::vector<vtkTextureObject*> GetLoaded() const;

  ScalarTexture Scalars;
  vtkTimeStamp ScalarsTime;
  vtkDataArray* LoadedScalars = nullptr;
  vtkImageData* LoadedImage = nullptr;
  std::array<int, 3> LoadedDimensions{};
  bool IntegerData = false;
  GradientTexture Gradients;
  EmptySpaceTexture EmptySpace;
  vtkTimeStamp EmptySpaceTime;
  CroppedRegions LoadedRegions;
  double Noise = 0.0;
  vtkTimeStamp NoiseTime;

  vtkNew<vtkTextureObject> Mask;
  vtkTimeStamp MaskTime;
  vtkImageData* LoadedMask = nullptr;

  TransferFunctionTable Table;
  GradientOpacityTable GradientOpacity;
  vtkTimeStamp TransferFunctionTime;
  vtkVolumeProperty* LoadedProperty = nullptr;
  GradientEstimator LoadedEstimator = GradientEstimator::CentralDifferences;
  vtkNew<vtkTextureObject> Extinction;
  vtkNew<vtkTextureObject> Color;
  vtkNew<vtkTextureObject> ColorIntegral;
  vtkNew<vtkTextureObject> Points;
  vtkNew<vtkTextureObject> GradientOpacityTexture;
};

}

#endif
