#include "BumpsScene.h"
#include "Catch.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>

#include <stdexcept>

using namespace penumbra;

namespace
{
std::vector<double> GetValues(vtkImageData* picture)
{
  vtkDataArray* scalars = picture->GetPointData()->GetScalars();
  std::vector<double> values;
  for (vtkIdType i = 0; i < scalars->GetNumberOfValues(); ++i)
  {
    values.push_back(scalars->GetVariantValue(i).ToDouble());
  }
  return values;
}
}

TEST_CASE("A picture has the pixels that its rays have, the bottom row first")
{
  ReferenceScene scene = MakeBumpsScene();
  scene.Size = { 20, 14 };
  const ReferenceIntegrator integrator(scene);
  const auto picture = integrator.Render();
  REQUIRE(picture);
  int dimensions[3];
  picture->Colors->GetDimensions(dimensions);
  CHECK(dimensions[0] == 20);
  CHECK(dimensions[1] == 14);
  REQUIRE(picture->Colors->GetScalarType() == VTK_FLOAT);
  double sumOfSquares = 0.0;
  double largest = 0.0;
  for (int y = 0; y < 14; ++y)
  {
    for (int x = 0; x < 20; ++x)
    {
      const ReferencePixel pixel = integrator.ComputePixel(x + 0.5, y + 0.5);
      for (int channel = 0; channel < 4; ++channel)
      {
        CHECK(picture->Colors->GetScalarComponentAsDouble(x, y, 0, channel) ==
          static_cast<float>(pixel.Color[channel]));
      }
      CHECK(
        picture->Errors->GetScalarComponentAsDouble(x, y, 0, 0) == static_cast<float>(pixel.Error));
      sumOfSquares += pixel.Error * pixel.Error;
      largest = std::max(largest, pixel.Error);
    }
  }
  const ReferenceStatistics& statistics = picture->Statistics;
  CHECK(statistics.LargestError == largest);
  CHECK(statistics.RootMeanSquareError == Approx(std::sqrt(sumOfSquares / 280.0)));
  CHECK(statistics.PixelsNotConverged == 0);
  CHECK(statistics.Samples > 280);
  CHECK(statistics.ShadowRays > statistics.Samples);
}

TEST_CASE("The picture does not depend on the number of threads")
{
  const ReferenceIntegrator integrator(MakeBumpsScene());
  std::optional<ReferencePicture> together;
  std::optional<ReferencePicture> alone;
  vtkSMPTools::LocalScope(
    vtkSMPTools::Config{ 5, "STDThread", false }, [&] { together = integrator.Render(); });
  vtkSMPTools::LocalScope(
    vtkSMPTools::Config{ 1, "STDThread", false }, [&] { alone = integrator.Render(); });
  CHECK(GetValues(together->Colors) == GetValues(alone->Colors));
  CHECK(GetValues(together->Errors) == GetValues(alone->Errors));
}

TEST_CASE("Progress rises to 1, and whoever is told may stop it")
{
  std::vector<double> told;
  ReferenceOptions options;
  options.Tolerance = 5.0;
  options.Progress = [&](double done)
  {
    told.push_back(done);
    return true;
  };
  ReferenceScene scene = MakeBumpsScene();
  scene.Size = { 40, 40 };
  CHECK(ReferenceIntegrator(scene, options).Render());
  CHECK(told.size() > 5);
  CHECK(std::is_sorted(told.begin(), told.end()));
  CHECK(told.front() == 0.0);
  CHECK(told.back() == 1.0);
  options.Progress = [](double done) { return done < 0.3; };
  CHECK_FALSE(ReferenceIntegrator(scene, options).Render());
}

TEST_CASE("A scene that cannot be rendered is refused")
{
  const ReferenceScene scene = MakeBumpsScene();
  const auto refuses = [](const ReferenceScene& wrong, const ReferenceOptions& options = {})
  { CHECK_THROWS_AS(ReferenceIntegrator(wrong, options), std::invalid_argument); };
  ReferenceScene wrong = scene;
  wrong.Volume = nullptr;
  refuses(wrong);
  wrong.Volume = vtkSmartPointer<vtkImageData>::New();
  refuses(wrong);
  wrong = scene;
  wrong.Property = nullptr;
  refuses(wrong);
  wrong = scene;
  wrong.Camera = nullptr;
  refuses(wrong);
  wrong = scene;
  wrong.Size = { 0, 4 };
  refuses(wrong);
  wrong = scene;
  VolumeGrid grid;
  grid.dimensions = { 8, 8, 7 };
  wrong.Mask = SampleField(grid, [](const Point&) { return 1.0; });
  refuses(wrong);
  ReferenceOptions options;
  options.Tolerance = 0.0;
  refuses(scene, options);
}

TEST_CASE("A volume that its matrix makes flat is not seen")
{
  ReferenceScene scene = MakeBumpsScene();
  scene.Transform = vtkSmartPointer<vtkMatrix4x4>::New();
  scene.Transform->SetElement(2, 2, 0.0);
  CHECK(ComputeMiddle(scene).Color[3] == 0.0);
}
