#include "AboutDialog.h"

#include <QMessageBox>

#include <vtkRenderWindow.h>
#include <vtkVersion.h>

#include <string>

namespace penumbra
{
namespace
{
QString LineOf(const std::string& capabilities, const std::string& label)
{
  const auto found = capabilities.find(label);
  if (found == std::string::npos)
  {
    return QObject::tr("not known before something is drawn");
  }
  const auto begin = found + label.size();
  const auto end = capabilities.find('\n', begin);
  return QString::fromStdString(capabilities.substr(begin, end - begin)).simplified();
}
}

//------------------------------------------------------------------------------
QString DescribeProgram(vtkRenderWindow* window)
{
  const std::string capabilities = window->GetNeverRendered() ? "" : window->ReportCapabilities();
  return QObject::tr("Penumbra %1\nVTK %2, Qt %3\nOpenGL renderer: %4\nOpenGL version: %5")
    .arg(PENUMBRA_VERSION, vtkVersion::GetVTKVersion(), qVersion(),
      LineOf(capabilities, "OpenGL renderer string:"),
      LineOf(capabilities, "OpenGL version string:"));
}

//------------------------------------------------------------------------------
void ShowAbout(QWidget* parent, vtkRenderWindow* window)
{
  QMessageBox::about(parent, QObject::tr("About Penumbra"),
    QObject::tr("Illuminated, shadowed direct volume rendering.\n\n") + DescribeProgram(window) +
      QObject::tr("\n\nNot a medical device: not for diagnosis."));
}

//------------------------------------------------------------------------------
void ShowKeys(QWidget* parent)
{
  QMessageBox::information(parent, QObject::tr("Mouse and keys"),
    QObject::tr("<table cellpadding='3'>"
                "<tr><td><b>Left button</b></td><td>turn</td></tr>"
                "<tr><td><b>Middle button, Shift + left</b></td><td>move</td></tr>"
                "<tr><td><b>Wheel, right button</b></td><td>zoom</td></tr>"
                "<tr><td><b>Arrow keys, + and -</b></td><td>turn, zoom</td></tr>"
                "<tr><td><b>Double click</b></td><td>aim the selected light there</td></tr>"
                "<tr><td><b>R</b></td><td>reset the camera</td></tr>"
                "<tr><td><b>1 to 6</b></td><td>look from front, back, left, right, above, "
                "below</td></tr>"
                "<tr><td><b>L, C</b></td><td>drag the selected light, the clipping in the "
                "view</td></tr>"
                "<tr><td><b>Ctrl+L</b></td><td>add a directional light</td></tr>"
                "<tr><td><b>Ctrl+Shift+L</b></td><td>remove the selected light</td></tr>"
                "<tr><td><b>Arrow keys on the ball</b></td><td>turn the light</td></tr>"
                "<tr><td><b>Space in a list of lights</b></td><td>switch the light on or "
                "off</td></tr>"
                "<tr><td><b>Right button in the chart</b></td><td>move and stretch all "
                "points</td></tr>"
                "<tr><td><b>Ctrl+Z, Ctrl+Y</b></td><td>undo, redo</td></tr>"
                "<tr><td><b>Ctrl+O, Ctrl+Shift+O</b></td><td>open a file, a folder</td></tr>"
                "<tr><td><b>Esc</b></td><td>cancel what is being read</td></tr>"
                "<tr><td><b>Ctrl+S, Ctrl+P, Ctrl+C</b></td><td>save the scene, save a picture, "
                "copy the picture</td></tr></table>"));
}

}
