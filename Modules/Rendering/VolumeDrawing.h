/**
 * @file    VolumeDrawing.h
 * @brief   draws a scene's picture: textures, program, draws
 */

#ifndef VolumeDrawing_h
#define VolumeDrawing_h

#include "AccumulationBuffer.h"
#include "DrawnScene.h"
#include "EnvironmentTextures.h"
#include "OpacityMaps.h"
#include "RayCounts.h"
#include "ShadowMaps.h"
#include "ShadowVolume.h"
#include "StandInBox.h"
#include "VolumeTextures.h"
#include "vtkIlluminationPass.h"

#include "vtkNew.h"
#include "vtkWeakPointer.h"

#include <array>
#include <cstddef>
#include <functional>
#include <string>

class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkShaderProgram;

namespace penumbra
{

/// What keeping shadows costs.
struct ShadowReport
{
  std::size_t Bytes = 0;
  int Updates = 0;            ///< lights that were computed since the drawing was made
  double UpdateSeconds = 0.0; ///< of the last computation
};

class VolumeDrawing
{
public:
  VolumeDrawing();

  /// Draws with the textures as they are loaded. imageSampleDistance: pixels of the viewport per
  /// ray. Empty, or why the volume is not drawn: one sentence.
  std::string Draw(vtkRenderer* renderer, const DrawnScene& scene, double imageSampleDistance);

  /// Draws the same picture out of sight, to count what its rays do. Empty, or why they are not
  /// counted.
  std::string Count(
    vtkRenderer* renderer, const DrawnScene& scene, double imageSampleDistance, RayCounts& counts);

  VolumeTextures& GetTextures() { return this->Textures; }
  const VolumeTextures& GetTextures() const { return this->Textures; }
  ShadowVolume& GetVolumeOfShadows() { return this->VolumeOfShadows; }
  ShadowMaps& GetMapsOfShadows() { return this->MapsOfShadows; }
  OpacityMaps& GetLayersOfShadows() { return this->LayersOfShadows; }
  ShadowReport GetShadowReport() const;
  /// About how long a draw may compute shadows that are kept; 0: until they are complete. One that
  /// leaves them incomplete draws nothing.
  void SetShadowSeconds(double seconds) { this->ShadowSeconds = seconds; }
  bool AreShadowsComplete() const;
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

  std::array<ShadowCache*, 3> GetCaches();
  std::array<const ShadowCache*, 3> GetCaches() const;
  bool UpdateShadows();
  /// With the program that is selected, and all its textures active for `draw`, which is told the
  /// viewport and returns false without float pictures.
  std::string DrawWith(vtkRenderer* renderer, const DrawnScene& scene,
    const std::function<bool(const AccumulationBuffer::Viewport&)>& draw);
  bool Gather(vtkRenderer* renderer, const AccumulationBuffer::Viewport& viewport,
    double imageSampleDistance);
  void DrawPart(vtkRenderer* renderer, const Part& part);
  void SetUniforms(vtkShaderProgram* program);
  void SetTiles(vtkShaderProgram* program);

  vtkNew<vtkIlluminationPass> Pass;
  StandInBox Box;
  VolumeTextures Textures;
  EnvironmentTextures Environment;
  ShadowVolume VolumeOfShadows;
  ShadowMaps MapsOfShadows;
  OpacityMaps LayersOfShadows;
  AccumulationBuffer Accumulation;
  const DrawnScene* Scene = nullptr;
  Part Current;
  bool Gathering = false;
  double ShadowSeconds = 0.0;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
};

}

#endif
