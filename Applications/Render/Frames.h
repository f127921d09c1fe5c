/**
 * @file    Frames.h
 * @brief   a scene's frames, and how long each took
 */

#ifndef Frames_h
#define Frames_h

#include "CommandLine.h"

#include <vtkSmartPointer.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

class vtkImageData;
class vtkRenderWindow;

namespace penumbra
{

class SceneRendering;

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
};

/// A window without an X server that shows the rendering in this size.
vtkSmartPointer<vtkRenderWindow> MakeWindow(
  SceneRendering& rendering, const std::array<int, 2>& size);

/**
 * Renders the first frame and the others that are asked for. `afterEachFrame` is called with the
 * number of the frame, from 0; what it throws ends the rendering.
 * @throw RenderingError where the window has no OpenGL.
 */
RenderedFrames RenderFrames(SceneRendering& rendering, vtkRenderWindow* window,
  const RenderCommand& command, const std::function<void(int)>& afterEachFrame);

}

#endif
