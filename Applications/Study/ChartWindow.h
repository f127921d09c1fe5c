/**
 * @class   ChartWindow
 * @brief   a chart in a window that nobody sees
 */

#ifndef ChartWindow_h
#define ChartWindow_h

#include "ChartLayout.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>

namespace penumbra
{

class ChartWindow
{
public:
  /// Renders. Each pixel of the layout becomes `scale` pixels.
  ChartWindow(const ChartLayout& layout, int scale);

  vtkRenderWindow* Get() const { return this->Window; }

private:
  vtkNew<vtkRenderWindow> Window;
};

}

#endif
