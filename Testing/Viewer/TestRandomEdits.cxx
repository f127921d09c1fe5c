#include "Catch.h"
#include "ImageComparison.h"
#include "RandomUser.h"

#include <QApplication>

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <limits>

#if __GLIBC__ * 100 + __GLIBC_MINOR__ >= 233
#include <malloc.h>
#endif

using namespace penumbra;

namespace
{
// Allocated by this process, in MiB; 0 where the system does not tell. What allocators keep of what
// was freed does not count.
double MemoryInUse()
{
#if __GLIBC__ * 100 + __GLIBC_MINOR__ >= 233
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd) / 1048576.0;
#else
  return 0.0;
#endif
}
}

TEST_CASE(
  "After 200 random edits a saved scene renders to the view's picture, and nothing leaks", "[slow]")
{
  constexpr unsigned int seed = 2026;
  ViewerSession session;
  session.Window.resize(700, 440); // so that many pictures are soon drawn
  REQUIRE(session.Open(session.Files.File));
  const CameraDescription camera = session.Window.GetView()->GetCamera();
  const auto editOften = [&]
  {
    RandomUser user(session, seed);
    vtkSmartPointer<vtkImageData> last;
    for (int edit = 0; edit < 200; ++edit)
    {
      user.EditOnce();
      QApplication::processEvents();
      last = session.TakePicture();
    }
    return last;
  };
  const auto picture = editOften();
  const std::string saved = session.Files.PathOf("saved.json");
  session.Window.Save(saved);
  CHECK(CompareImages(picture, RenderScene(saved, session.Files)).rmse <= 1.0);

  // The same edits again need nothing new, but for programs: how many kinds of frames are drawn
  // between edits is a matter of time, and each kind that comes up fills the caches of programs,
  // VTK's and OpenGL's. A picture at each edit brings most of them up in the first round: the next
  // grow by 3 to 25 MiB, then by less than 5. What grows every time is a leak; one picture or
  // texture leaked with each edit would be 100 MiB and more.
  constexpr double most = 50.0;
  double leastGrowth = std::numeric_limits<double>::max();
  for (int round = 0; round < 2 && leastGrowth > most; ++round)
  {
    const double memoryBefore = MemoryInUse();
    session.Document.GetHistory()->setIndex(0);
    session.Document.GetHistory()->clear();
    session.Window.GetView()->SetCamera(camera);
    CHECK(CompareImages(picture, editOften()).rmse == 0.0);
    leastGrowth = std::min(leastGrowth, MemoryInUse() - memoryBefore);
  }
  CHECK(leastGrowth <= most);
}
