/**
 * @file    VolumeDrawing.h
 * @brief   draws a scene's picture: textures, program, draws
 */

#ifndef VolumeDrawing_h
#define VolumeDrawing_h

#include "AccumulationBuffer.h"
#include "DrawnScene.h"
#include "EnvironmentTextures.h"
#include "IlluminationPass.h"
#include "ShadowMaps.h"
#include "ShadowVolume.h"
#include "StandInBox.h"
#include "VolumeTextures.h"

#include "vtkNew.h"
#include "vtkWeakPointer.h"

class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkShaderProgram;

namespace penumbra
{

class VolumeDrawing
{
public:
  VolumeDrawing();

  enum class Result
  {
    Drawn,
    NoProgram,         ///< the shader did not compile or link
    NoFloatFramebuffer ///< a picture of several draws or of fewer pixels has nowhere to be gathered
  };

  /// Draws with the textures as they are loaded. imageSampleDistance: pixels of the viewport per
  /// ray.
  Result Draw(vtkRenderer* renderer, const DrawnScene& scene, double imageSampleDistance);

  VolumeTextures& GetTextures() { return this->Textures; }
  const VolumeTextures& GetTextures() const { return this->Textures; }
  ShadowVolume& GetVolumeOfShadows() { return this->VolumeOfShadows; }
  ShadowMaps& GetMapsOfShadows() { return this->MapsOfShadows; }
  const ShadowVolume& GetVolumeOfShadows() const { return this->VolumeOfShadows; }
  const ShadowMaps& GetMapsOfShadows() const { return this->MapsOfShadows; }
  EnvironmentTextures& GetEnvironment() { return this->Environment; }
  const vtkIlluminationPass* GetPass() const { return this->Pass; }

  void Release(vtkOpenGLRenderWindow* window);

private:
  /// The part of the framebuffer and of the view rays that one draw covers.
  struct Part
  {
    AccumulationBuffer::Viewport Viewport;
    int FirstStep = 0;
    int LastStep = 0;
  };

  std::array<ShadowCache*, 2> GetCaches();
  bool UpdateShadows();
  bool Gather(vtkRenderer* renderer, const AccumulationBuffer::Viewport& viewport,
    double imageSampleDistance);
  void DrawPart(vtkRenderer* renderer, const Part& part);
  void SetUniforms(vtkShaderProgram* program);

  vtkNew<vtkIlluminationPass> Pass;
  StandInBox Box;
  VolumeTextures Textures;
  EnvironmentTextures Environment;
  ShadowVolume VolumeOfShadows;
  ShadowMaps MapsOfShadows;
  AccumulationBuffer Accumulation;
  const DrawnScene* Scene = nullptr;
  Part Current;
  bool Gathering = false;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
};

}

#endif
