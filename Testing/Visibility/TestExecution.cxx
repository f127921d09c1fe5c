#include "Catch.h"
#include "LitShells.h"
#include "VTKMessages.h"

#include <vtkPointData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <thread>

using namespace penumbra;

TEST_CASE("Progress rises to 1, in many steps, in the thread that updates")
{
  LitShells scene;
  std::vector<double> progress;
  bool sameThread = true;
  const std::thread::id thread = std::this_thread::get_id();
  const Observation observation(scene.Filter, vtkCommand::ProgressEvent,
    [&]()
    {
      progress.push_back(scene.Filter->GetProgress());
      sameThread = sameThread && std::this_thread::get_id() == thread;
    });
  scene.Filter->Update();
  CHECK(sameThread);
  CHECK(progress.size() > 50);
  CHECK(std::is_sorted(progress.begin(), progress.end()));
  CHECK(progress.front() == 0.0);
  CHECK(progress.back() == 1.0);
}

TEST_CASE("An aborted filter stops at once, with an empty output, and executes when asked again")
{
  LitShells scene;
  const std::vector<float> expected = LitShells().Compute();
  int events = 0;
  int eventsOnceAborted = 0;
  VTKMessages messages;
  {
    const Observation observation(scene.Filter, vtkCommand::ProgressEvent,
      [&]()
      {
        // The end of an execution may be told as progress of 1 even so.
        const double progress = scene.Filter->GetProgress();
        ++events;
        eventsOnceAborted += scene.Filter->GetAbortExecute() != 0 && progress < 1.0;
        scene.Filter->SetAbortExecute(progress >= 0.25);
      });
    scene.Filter->Update();
  }
  CHECK(events > 10);
  CHECK(eventsOnceAborted == 0);
  CHECK(scene.Filter->GetOutput()->GetNumberOfPoints() == 0);
  CHECK(scene.Filter->GetOutput()->GetPointData()->GetNumberOfArrays() == 0);
  scene.Filter->SetAbortExecute(0);
  CHECK(GetLargestDifference(scene.Compute(), expected) == 0.0);
  CHECK(messages.Text().empty());
}

TEST_CASE("The number of threads changes no bit")
{
  const auto compute = [](int threads)
  {
    LitShells scene;
    scene.AddPoint({ 3.0, 4.0, 5.0 })->SetShadowToHard();
    std::vector<float> visibility;
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads },
      [&]()
      {
        visibility = scene.Compute(0);
        const std::vector<float> hard = scene.Compute(1);
        visibility.insert(visibility.end(), hard.begin(), hard.end());
      });
    return visibility;
  };
  const std::vector<float> expected = compute(1);
  CHECK(GetLargestDifference(compute(2), expected) == 0.0);
  CHECK(GetLargestDifference(compute(5), expected) == 0.0);
}
