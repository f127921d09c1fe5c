#include "OffscreenWindow.h"

#include "Catch.h"
#include "ImageComparison.h"
#include "RenderToImage.h"
#include "SyntheticVolumes.h"

#include <vtkColorTransferFunction.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkObjectFactoryCollection.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkVersionMacros.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <array>
#include <map>

using namespace penumbra;

namespace
{
using Colour = std::array<int, 3>;

Colour At(vtkImageData* picture, int x, int y)
{
  const auto* pixel = static_cast<unsigned char*>(picture->GetScalarPointer(x, y, 0));
  return { pixel[0], pixel[1], pixel[2] };
}

/// A window whose lower half is red and whose upper half is the given colour.
struct TwoColours
{
  explicit TwoColours(const Colour& above)
    : Above(above)
  {
    this->Lower->SetViewport(0, 0, 1, 0.5);
    this->Upper->SetViewport(0, 0.5, 1, 1);
    this->Lower->SetBackground(1, 0, 0);
    this->Upper->SetBackground(above[0] / 255.0, above[1] / 255.0, above[2] / 255.0);
    this->Window->AddRenderer(this->Lower);
    this->Window->AddRenderer(this->Upper);
  }

  void CheckPicture(int width, int height)
  {
    const auto picture = RenderToImage(this->Window);
    REQUIRE(picture->GetDimensions()[0] == width);
    REQUIRE(picture->GetDimensions()[1] == height);
    CHECK(At(picture, 0, 0) == Colour{ 255, 0, 0 });
    CHECK(At(picture, width - 1, height / 2 - 1) == Colour{ 255, 0, 0 });
    CHECK(At(picture, 0, height / 2) == this->Above);
    CHECK(At(picture, width - 1, height - 1) == this->Above);
  }

  const Colour Above;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Lower;
  vtkNew<vtkRenderer> Upper;
};

constexpr Colour blue = { 0, 0, 255 };
constexpr Colour grey = { 51, 102, 153 };
}

TEST_CASE("A plain window is of the chosen kind and has OpenGL")
{
  const std::string kind = OffscreenWindowKind();
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
  const char* offscreenClasses[] = { "vtkOSOpenGLRenderWindow", "vtkEGLRenderWindow" };
#else
  const char* offscreenClasses[] = { "vtkOffscreenWindow", "vtkOffscreenWindow" };
#endif
  const std::map<std::string, std::string> classes = { { "osmesa", offscreenClasses[0] },
    { "egl", offscreenClasses[1] }, { "native", "vtkXOpenGLRenderWindow" } };
  vtkNew<vtkRenderWindow> window;
  CHECK(window->GetClassName() == classes.at(kind));
  CHECK(window->SupportsOpenGL());
  window->Render();
  CHECK_THAT(window->ReportCapabilities(), Catch::Matchers::ContainsSubstring("OpenGL"));
}

TEST_CASE("Choosing the window twice is choosing it once")
{
  const int before = vtkObjectFactory::GetRegisteredFactories()->GetNumberOfItems();
  UseOffscreenWindows();
  CHECK(vtkObjectFactory::GetRegisteredFactories()->GetNumberOfItems() == before);
}

TEST_CASE("A window can be resized before and after its first picture")
{
  TwoColours scene(blue);
  scene.Window->SetSize(64, 32);
  scene.CheckPicture(64, 32);
  scene.Window->SetSize(200, 300);
  scene.CheckPicture(200, 300);
  scene.Window->SetSize(10, 8);
  scene.CheckPicture(10, 8);
}

TEST_CASE("Windows keep their pictures apart when they take turns")
{
  TwoColours a(blue);
  TwoColours b(grey);
  a.Window->SetSize(40, 20);
  b.Window->SetSize(30, 50);
  for (int turn = 0; turn < 3; ++turn)
  {
    a.CheckPicture(40, 20);
    b.CheckPicture(30, 50);
  }
}

TEST_CASE("A window goes while another one stays")
{
  TwoColours stays(blue);
  stays.Window->SetSize(40, 20);
  for (int i = 0; i < 5; ++i)
  {
    TwoColours goes(grey);
    goes.Window->SetSize(30, 50);
    goes.CheckPicture(30, 50);
    stays.CheckPicture(40, 20);
  }
  stays.CheckPicture(40, 20);
}

TEST_CASE("A finalized window can be used again")
{
  TwoColours scene(grey);
  scene.Window->SetSize(40, 20);
  scene.CheckPicture(40, 20);
  scene.Window->Finalize();
  scene.CheckPicture(40, 20);
}

TEST_CASE("A window can be 4096 pixels wide and high")
{
  TwoColours scene(grey);
  scene.Window->SetSize(4096, 4096);
  scene.CheckPicture(4096, 4096);
}

TEST_CASE("A window draws volumes, the same each time")
{
  const auto draw = []
  {
    vtkNew<vtkGPUVolumeRayCastMapper> mapper;
    mapper->SetInputData(MakeBall({}, 10.0, 4.0));
    mapper->UseJitteringOff();
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(0, 0.0);
    opacity->AddPoint(255, 0.5);
    vtkNew<vtkColorTransferFunction> white;
    white->AddRGBPoint(0, 1.0, 1.0, 1.0);
    vtkNew<vtkVolume> volume;
    volume->SetMapper(mapper);
    volume->GetProperty()->SetScalarOpacity(opacity);
    volume->GetProperty()->SetColor(white);
    vtkNew<vtkRenderer> renderer;
    renderer->AddVolume(volume);
    vtkNew<vtkRenderWindow> window;
    window->SetSize(60, 60);
    window->AddRenderer(renderer);
    return RenderToImage(window);
  };
  const auto picture = draw();
  CHECK(At(picture, 30, 30)[0] > 250);
  CHECK(At(picture, 1, 1) == Colour{ 0, 0, 0 });
  CHECK(CompareImages(picture, draw()).largest == 0.0);
}
