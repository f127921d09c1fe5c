#include "Catch.h"
#include "ImageComparison.h"
#include "Picture.h"
#include "SceneRendering.h"
#include "StillFrame.h"
#include "ViewDecorations.h"
#include "ViewerSession.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkIlluminatedVolumeMapper.h>
#include <vtkImageData.h>

using namespace penumbra;

TEST_CASE("Shadows that take long are computed piece by piece before the strips", "[still]")
{
  ViewerSession session;
  REQUIRE(session.Open(session.Files.File));
  session.Document.Edit("edit",
    [](SceneDescription& scene)
    {
      scene.Shadows.Technique = TechniqueChoice::Volume;
      scene.Shadows.Resolution = 6.0;
    });
  VolumeView* view = session.Window.GetView();
  SceneRendering* rendering = view->GetRendering();
  vtkIlluminatedVolumeMapper* mapper = rendering->GetIlluminatedMapper();
  mapper->SetImageSampleDistance(1.0f); // whatever was drawn last
  view->GetDecorations()->Hide(true);
  StillFrame still;
  still.Begin(rendering->GetRenderer(), mapper, 3);
  int draws = 1;
  while (!still.DrawNext())
  {
    ++draws;
  }
  still.End();
  CHECK(draws > 4);
  const auto drawn = ReadPicture(view->renderWindow());
  CHECK(CompareImages(drawn, view->TakePicture()).rmse == 0.0);
}
