/**
 * @file    ViewerProgram.h
 * @brief   the viewer from the command line to the last window closed
 */

#ifndef ViewerProgram_h
#define ViewerProgram_h

class vtkMessageCollector;

namespace penumbra
{

struct ViewerCommand;

/// To be called before the QApplication is made: OpenGL as VTK needs it, and one line on stderr and
/// exit status 1, where Qt would abort, if there is no display.
void PrepareQt();

/**
 * @throw InputError where the screenshot's scene cannot be opened, RenderingError where its picture
 * cannot be made.
 */
void RunViewer(const ViewerCommand& command, int argc, char* argv[], vtkMessageCollector* messages);

}

#endif
