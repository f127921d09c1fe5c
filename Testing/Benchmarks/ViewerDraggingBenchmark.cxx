// Opens a scene, a volume or a folder in the viewer's window, drags the camera and then the
// selected light round and round as a mouse does, and prints how many frames a second were drawn,
// and how long the window did not answer while the whole picture followed.

#include "DirectionBall.h"
#include "MainWindow.h"
#include "SceneRendering.h"
#include "ViewerProgram.h"
#include "VolumeView.h"
#include "WaitFor.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <QTimer>

#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkVolume.h>
#include <vtkVolumeMapper.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

using namespace penumbra;

namespace
{

constexpr double SecondsOfReading = 120.0;
constexpr double SecondsOfPause = 4.0; // in which the presets' thumbnails are drawn, too
constexpr double SecondsOfDrag = 8.0;
constexpr double SecondsOfTurn = 4.0;
constexpr double RadiusOfTurn = 60.0; // in pixels
constexpr int MillisecondsOfMouse = 8;

void Send(QWidget* widget, QEvent::Type type, const QPointF& place)
{
  const bool moves = type == QEvent::MouseMove;
  const bool released = type == QEvent::MouseButtonRelease;
  QMouseEvent event(type, place, moves ? Qt::NoButton : Qt::LeftButton,
    released ? Qt::NoButton : Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(widget, &event);
}

// Waits for the whole picture. Returns the longest time without an answer to an event, in
// milliseconds.
qint64 WaitForPicture(const VolumeView* view)
{
  QElapsedTimer clock;
  qint64 longest = 0;
  QTimer beat;
  QObject::connect(&beat, &QTimer::timeout, [&] { longest = std::max(longest, clock.restart()); });
  clock.start();
  beat.start(MillisecondsOfMouse);
  WaitFor([view] { return view->IsRefined(); }, SecondsOfReading);
  return longest;
}

void Drag(const char* what, QWidget* widget, VolumeView* view)
{
  QElapsedTimer clock;
  QElapsedTimer sinceFrame;
  int frames = 0;
  qint64 longest = 0;
  const auto connection = QObject::connect(view, &VolumeView::cameraMoved,
    [&]
    {
      ++frames;
      longest = std::max(longest, sinceFrame.restart());
    });
  const QPointF middle = QRectF(widget->rect()).center();
  const auto place = [&]
  {
    const double angle = 2.0 * M_PI * clock.elapsed() / (1000.0 * SecondsOfTurn);
    return middle + RadiusOfTurn * QPointF(std::cos(angle), std::sin(angle));
  };
  clock.start();
  sinceFrame.start();
  Send(widget, QEvent::MouseButtonPress, place());
  QTimer mouse;
  mouse.setTimerType(Qt::PreciseTimer);
  QObject::connect(&mouse, &QTimer::timeout, [&] { Send(widget, QEvent::MouseMove, place()); });
  mouse.start(MillisecondsOfMouse);
  WaitFor([] { return false; }, SecondsOfDrag);
  const double seconds = clock.elapsed() / 1000.0;
  mouse.stop();
  auto* const mapper =
    vtkGPUVolumeRayCastMapper::SafeDownCast(view->GetRendering()->GetVolume()->GetMapper());
  std::cout << what << ": " << frames / seconds << " frames a second, the longest after " << longest
            << " ms; at last one ray in " << mapper->GetImageSampleDistance() << " x "
            << mapper->GetImageSampleDistance() << " pixels" << std::endl;
  Send(widget, QEvent::MouseButtonRelease, place());
  QObject::disconnect(connection);
  std::cout << what << ": no answer for " << WaitForPicture(view) << " ms at most until it is whole"
            << std::endl;
  WaitFor([] { return false; }, SecondsOfPause);
}

}

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "usage: ViewerDraggingBenchmark FILE-OR-FOLDER\n";
    return EXIT_FAILURE;
  }
  PrepareQt();
  QApplication application(argc, argv);
  MainWindow window(PENUMBRA_DICOM_PARSER);
  window.resize(1280, 800);
  window.show();
  window.Open(argv[1]);
  VolumeView* view = window.GetView();
  if (!WaitFor([view] { return view->GetRendering() && view->IsRefined(); }, SecondsOfReading))
  {
    std::cerr << argv[1] << " was not shown\n";
    return EXIT_FAILURE;
  }
  WaitFor([] { return false; }, SecondsOfPause);
  std::cout << "view of " << view->width() << " x " << view->height() << " pixels" << std::endl;
  Drag("camera", view, view);
  Drag("light", window.findChild<DirectionBall*>(), view);
  return EXIT_SUCCESS;
}
