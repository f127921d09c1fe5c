/**
 * @file    AboutDialog.h
 * @brief   what this program is, and which keys it knows
 */

#ifndef AboutDialog_h
#define AboutDialog_h

#include <QString>

class QWidget;
class vtkRenderWindow;

namespace penumbra
{

/// Versions of Penumbra, VTK and Qt, and what OpenGL draws with.
QString DescribeProgram(vtkRenderWindow* window);

void ShowAbout(QWidget* parent, vtkRenderWindow* window);
void ShowKeys(QWidget* parent);

}

#endif
