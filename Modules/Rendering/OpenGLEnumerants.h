/**
 * @file    OpenGLEnumerants.h
 * @brief   OpenGL's names, from the loader that this VTK was built with
 */

#ifndef OpenGLEnumerants_h
#define OpenGLEnumerants_h

#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#endif
