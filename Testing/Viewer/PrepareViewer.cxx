#include "PrepareTests.h"
#include "ViewerProgram.h"

#include <QApplication>
#include <QDir>
#include <QSettings>
#include <QStandardPaths>

#include <cstdio>
#include <stdexcept>
#include <string>

namespace
{
// An X server of the test's own, which ends with its last client. It says which display it took.
std::string StartXServer()
{
  FILE* server =
    popen("Xvfb -displayfd 1 -terminate -nolisten tcp -screen 0 1600x1200x24 2>/dev/null", "r");
  int display = -1;
  if (!server || std::fscanf(server, "%d", &display) != 1)
  {
    throw std::runtime_error("SKIPPED: there is no Xvfb to show windows on (Debian: xvfb)");
  }
  return ":" + std::to_string(display); // the pipe stays open: closing it would wait for the end
}
}

void penumbra::PrepareTests()
{
  qputenv("DISPLAY", QByteArray::fromStdString(StartXServer()));
  qputenv("QT_QPA_PLATFORM", "xcb");
  qputenv("LC_ALL", "C.UTF-8");
  QStandardPaths::setTestModeEnabled(true);
  QSettings::setPath(
    QSettings::NativeFormat, QSettings::UserScope, QDir::tempPath() + "/penumbra-viewer-tests");
  penumbra::PrepareQt();
  static int argc = 1;
  static char name[] = "ViewerTests";
  static char* argv[] = { name, nullptr };
  new QApplication(argc, argv); // lives as long as the process
}
