/**
 * @file    TextureSampling.h
 * @brief   how a texture is read between its texels and beyond its edges
 */

#ifndef TextureSampling_h
#define TextureSampling_h

class vtkOpenGLRenderWindow;
class vtkTextureObject;

namespace penumbra
{

/// Between texels by the filter, vtkTextureObject's Nearest or Linear; beyond the edges as at them.
void SetSampling(vtkTextureObject* texture, int filter);

/// Readies a texture to be made anew for the window, of any format, and to be sampled so.
void ResetTexture(vtkTextureObject* texture, vtkOpenGLRenderWindow* window, int filter);

}

#endif
