#include "WaitFor.h"

#include <QApplication>
#include <QElapsedTimer>

namespace penumbra
{

//------------------------------------------------------------------------------
bool WaitFor(const std::function<bool()>& condition, double seconds)
{
  QElapsedTimer timer;
  timer.start();
  while (!condition() && timer.elapsed() < 1000.0 * seconds)
  {
    QApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents, 20);
  }
  return condition();
}

}
