/**
 * @file RenderToImage.h
 * @brief The picture that a window shows.
 */
#ifndef RenderToImage_h
#define RenderToImage_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

class vtkRenderWindow;

namespace penumbra
{
/**
 * Renders the window and returns its picture as 8-bit RGB, bottom row first.
 * @throw std::runtime_error where the window has no OpenGL.
 */
vtkSmartPointer<vtkImageData> RenderToImage(vtkRenderWindow* window);
}

#endif
