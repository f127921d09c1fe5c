/**
 * @file GLXFunctions.h
 * @brief Lets a VTK that was built for X alone find its OpenGL functions in another context.
 *
 * VTK before 9.4 loads OpenGL through GLEW, which asks GLX for every function. GLXFunctions.cxx
 * defines those few GLX functions in the program itself, where the dynamic linker finds them
 * before those of libGLX. They answer from the given context while an OpenGLFunctionsFrom lives,
 * and pass the question on to libGLX at all other times, so that windows on an X server still work.
 */
#ifndef GLXFunctions_h
#define GLXFunctions_h

namespace penumbra
{
class OffscreenContext;

class OpenGLFunctionsFrom
{
public:
  explicit OpenGLFunctionsFrom(const OffscreenContext& context);
  ~OpenGLFunctionsFrom();
  OpenGLFunctionsFrom(const OpenGLFunctionsFrom&) = delete;
  OpenGLFunctionsFrom& operator=(const OpenGLFunctionsFrom&) = delete;
};
}

#endif
