/**
 * @file    AccumulationBuffer.h
 * @brief   where a picture of several draws, or of fewer pixels, is gathered
 *
 * Two float pictures take turns: a draw reads what the draws before it gathered from one and writes
 * to the other. The finished picture is put over the viewport, stretched to its size.
 */

#ifndef AccumulationBuffer_h
#define AccumulationBuffer_h

#include "VolumePlacement.h"

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkTextureObject.h"

#include <array>
#include <functional>

class vtkOpenGLRenderWindow;

namespace penumbra
{

class AccumulationBuffer
{
public:
  /// A viewport in pixels of the window.
  struct Viewport
  {
    int X = 0;
    int Y = 0;
    int Width = 0;
    int Height = 0;
  };

  /// Calls draw(i) for each of the draws with the buffer bound for drawing. False without float
  /// pictures.
  bool Gather(vtkOpenGLRenderWindow* window, const Viewport& viewport, int width, int height,
    int draws, const std::function<void(int)>& draw);

  /// To be called just before a draw's primitives: they replace what they cover of the whole
  /// picture.
  void PreparePrimitives(vtkOpenGLRenderWindow* window);

  /// Unit of the texture that the draw in progress reads.
  int GetPreviousTextureUnit();

  /// Puts what was gathered over the viewport.
  void Composite(vtkOpenGLRenderWindow* window, const Viewport& viewport);

  /// Red, green and blue of what was gathered, summed over all pixels.
  Vector3 Sum();

  void Release(vtkOpenGLRenderWindow* window);

private:
  bool Resize(vtkOpenGLRenderWindow* window, int width, int height);
  void Clear(vtkOpenGLRenderWindow* window, int target);

  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  std::array<vtkNew<vtkTextureObject>, 2> Pictures;
  vtkTextureObject* Previous = nullptr;
  vtkTextureObject* Gathered = nullptr;
};

}

#endif
