/**
 * @file    Frames.h
 * @brief   a scene's frames, and how long each took
 */

#ifndef Frames_h
#define Frames_h

#include "CommandLine.h"
#include "ReferenceIntegrator.h"

#include <vtkSmartPointer.h>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkImageData;
class vtkRenderWindow;

namespace penumbra
{

class SceneRendering;
struct SceneDescription;
struct SceneVoxels;

struct FrameTime
{
  /// By the clock, until the picture was complete.
  double Seconds = 0.0;
  /// Of the processor, by all threads.
  double CpuSeconds = 0.0;
};

struct RenderedFrames
{
  /// The scene as it was described, before any change.
  vtkSmartPointer<vtkImageData> Picture;
  /// With all that is done only once: textures, shaders.
  FrameTime First;
  /// The frames after it.
  std::vector<FrameTime> Others;
  /// Which driver drew them.
  std::string OpenGLRenderer;
  /// Of the picture, where the reference integrator made it.
  std::optional<ReferenceStatistics> Reference;
};

/// How a scene's frames are drawn.
struct FrameDrawing
{
  /// Draws one, and returns when it is complete.
  std::function<void()> Draw;
  /// What was drawn last, RGBA.
  std::function<vtkSmartPointer<vtkImageData>()> TakePicture;
  std::string Renderer;
  std::shared_ptr<std::optional<ReferenceStatistics>> Statistics;
};

/// A window without an X server that shows the rendering in this size.
vtkSmartPointer<vtkRenderWindow> MakeWindow(
  SceneRendering& rendering, const std::array<int, 2>& size);

/// By OpenGL. @throw RenderingError where the window has none.
FrameDrawing DrawInWindow(vtkRenderWindow* window);

/// By the reference integrator. The arguments must outlive the drawing.
FrameDrawing DrawReference(
  const SceneDescription& scene, const SceneVoxels& voxels, SceneRendering& rendering);

/// Draws one frame.
FrameTime TimeFrame(const FrameDrawing& drawing);

/**
 * Renders the first frame and the others that are asked for. `afterEachFrame` is called with the
 * number of the frame, from 0; what it throws ends the rendering.
 */
RenderedFrames RenderFrames(SceneRendering& rendering, const FrameDrawing& drawing,
  const RenderCommand& command, const std::function<void(int)>& afterEachFrame);

}

#endif
