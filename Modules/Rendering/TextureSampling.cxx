#include "TextureSampling.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

namespace penumbra
{

//------------------------------------------------------------------------------
void SetSampling(vtkTextureObject* texture, int filter)
{
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetWrapR(vtkTextureObject::ClampToEdge);
  texture->SetMinificationFilter(filter);
  texture->SetMagnificationFilter(filter);
}

//------------------------------------------------------------------------------
void ResetTexture(vtkTextureObject* texture, vtkOpenGLRenderWindow* window, int filter)
{
  texture->SetContext(window);
  texture->ResetFormatAndType();
  SetSampling(texture, filter);
}

}
