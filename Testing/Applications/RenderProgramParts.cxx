#include "Catch.h"
#include "RunProgram.h"
#include "SyntheticVolumes.h"

#include "InputError.h"
#include "OutputFile.h"
#include "SceneChange.h"
#include "SceneDefaults.h"
#include "SceneFile.h"
#include "SceneParser.h"
#include "SceneRendering.h"
#include "vtkMessageCollector.h"

#include <nlohmann/json.hpp>

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeLight.h>
#include <vtkVolumeProperty.h>

#include <array>
#include <vector>

using namespace penumbra;

namespace
{
// Looks along -z from (0,0,10) at the origin, with y up.
struct ChangingScene
{
  explicit ChangingScene(const std::string& lights, const std::string& opacity = "[[0,0],[100,1]]")
    : Volume(MakeRamp({}, 0))
    , Rendering(Resolve(lights, opacity), { this->Volume, nullptr })
  {
  }

  SceneDescription Resolve(const std::string& lights, const std::string& opacity) const
  {
    SceneDescription scene = ParseScene(ParseJson(R"({ "volume": { "file": "v.mhd" },
      "transferFunction": { "opacity": )" +
                                          opacity + R"( },
      "camera": { "position": [0,0,10], "focalPoint": [0,0,0], "viewUp": [0,1,0] },
      "lights": [)" + lights + "] }"),
      "");
    ResolveScene(scene, this->Volume);
    return scene;
  }

  vtkVolumeLight* Light() const { return this->Rendering.GetLights().front(); }

  Vector3 LightDirection() const
  {
    Vector3 position;
    Vector3 target;
    this->Light()->GetPosition(position.data());
    this->Light()->GetFocalPoint(target.data());
    return Difference(target, position);
  }

  vtkSmartPointer<vtkImageData> Volume;
  SceneRendering Rendering;
};

const double sine = std::sin(std::acos(-1.0) / 180.0);
const double cosine = std::cos(std::acos(-1.0) / 180.0);
}

TEST_CASE("Changing a light turns it by one degree about the view-up axis")
{
  ChangingScene directional(R"({ "direction": [1,5,0] })");
  const Vector3 before = directional.LightDirection();
  ChangeScene(directional.Rendering, SceneChange::Light);
  const Vector3 after = directional.LightDirection();
  CHECK(after[1] == Approx(before[1]));
  CHECK(after[0] == Approx(before[0] * cosine));
  CHECK(after[2] == Approx(-before[0] * sine));

  ChangingScene point(R"({ "type": "point", "position": [10,3,0] })");
  ChangeScene(point.Rendering, SceneChange::Light);
  const double* position = point.Light()->GetPosition();
  CHECK(position[0] == Approx(10.0 * cosine));
  CHECK(position[1] == Approx(3.0));
  CHECK(position[2] == Approx(-10.0 * sine));
}

TEST_CASE("The other changes change what they say by a little")
{
  ChangingScene scene(R"({ "diffuse": [1,0.5,0] })");
  ChangeScene(scene.Rendering, SceneChange::LightColour);
  CHECK(scene.Light()->GetDiffuseColor()[1] == Approx(0.495));

  vtkPiecewiseFunction* opacity = scene.Rendering.GetVolume()->GetProperty()->GetScalarOpacity();
  ChangeScene(scene.Rendering, SceneChange::Opacity);
  CHECK(opacity->GetValue(50.255) == Approx(0.5));
  CHECK(opacity->GetSize() == 2);

  ChangeScene(scene.Rendering, SceneChange::Camera);
  const double* eye = scene.Rendering.GetRenderer()->GetActiveCamera()->GetPosition();
  CHECK(eye[0] == Approx(10.0 * sine));
  CHECK(eye[2] == Approx(10.0 * cosine));
}

TEST_CASE("Steps of the opacity stay as they are where it moves")
{
  ChangingScene scene("{}", "[[0,0.5],[100,0],[100,1],[100.3,1],[100.3,0.25],[200,0]]");
  vtkPiecewiseFunction* opacity = scene.Rendering.GetVolume()->GetProperty()->GetScalarOpacity();
  std::vector<std::array<double, 4>> before(static_cast<std::size_t>(opacity->GetSize()));
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    opacity->GetNodeValue(static_cast<int>(i), before[i].data());
  }
  constexpr int moves = 10;
  for (int i = 0; i < moves; ++i)
  {
    ChangeScene(scene.Rendering, SceneChange::Opacity);
  }
  REQUIRE(opacity->GetSize() == static_cast<int>(before.size()));
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    double after[4];
    opacity->GetNodeValue(static_cast<int>(i), after);
    CHECK(after[0] == Approx(before[i][0] + 0.255 * moves));
    CHECK(after[1] == before[i][1]);
    CHECK(after[2] == before[i][2]);
    CHECK(after[3] == before[i][3]);
  }
}

TEST_CASE("A change of a light needs a light")
{
  CHECK_THROWS_AS(CheckChange(SceneChange::Light, 0), InputError);
  CHECK_THROWS_AS(CheckChange(SceneChange::LightColour, 0), InputError);
  CHECK_NOTHROW(CheckChange(SceneChange::Camera, 0));
  CHECK_NOTHROW(CheckChange(SceneChange::Light, 1));
}

TEST_CASE("A file appears when it is complete, and only then")
{
  const TemporaryFolder folder;
  folder.Write("kept", "old");
  {
    OutputFile file("--output", folder.PathOf("kept"));
    CHECK(folder.Names() == std::vector<std::string>{ "kept" });
    file.Write("new");
    CHECK(ReadAll(folder.PathOf("kept")) == "old");
  }
  CHECK(folder.Names() == std::vector<std::string>{ "kept" });
  CHECK(ReadAll(folder.PathOf("kept")) == "old");

  OutputFile file("--output", folder.PathOf("kept"));
  file.Write("new");
  file.Commit();
  CHECK(folder.Names() == std::vector<std::string>{ "kept" });
  CHECK(ReadAll(folder.PathOf("kept")) == "new");
}

TEST_CASE("A file's name may be as long as the file system takes it")
{
  const TemporaryFolder folder;
  const std::string name = std::string(246, 'n') + ".json";
  {
    OutputFile file("--report", folder.PathOf(name));
    file.Write("new");
    file.Commit();
  }
  CHECK(folder.Names() == std::vector<std::string>{ name });
  CHECK_THROWS_WITH(OutputFile("--report", folder.PathOf(std::string(300, 'n') + ".json")),
    !Catch::Matchers::ContainsSubstring("no file can be written to the folder"));
  CHECK(folder.Names() == std::vector<std::string>{ name });
}

TEST_CASE("A file that is named by a link is written where the link leads")
{
  const TemporaryFolder folder;
  folder.Write("kept/there.json", "old");
  const std::string target = GENERATE("kept/there.json", "kept/not yet.json");
  std::filesystem::create_symlink(target, folder.PathOf("second.json"));
  std::filesystem::create_symlink(folder.PathOf("second.json"), folder.PathOf("first.json"));
  OutputFile file("--report", folder.PathOf("first.json"));
  file.Write("new");
  file.Commit();
  CHECK(std::filesystem::is_symlink(folder.PathOf("first.json")));
  CHECK(std::filesystem::is_symlink(folder.PathOf("second.json")));
  CHECK(std::filesystem::is_regular_file(folder.PathOf(target)));
  CHECK(ReadAll(folder.PathOf(target)) == "new");
  CHECK(folder.Names() == std::vector<std::string>{ "first.json", "kept", "second.json" });
}

TEST_CASE("A link that leads in a circle is refused")
{
  const TemporaryFolder folder;
  std::filesystem::create_symlink("b.json", folder.PathOf("a.json"));
  std::filesystem::create_symlink("a.json", folder.PathOf("b.json"));
  CHECK_THROWS_AS(OutputFile("--report", folder.PathOf("a.json")), InputError);
}

TEST_CASE("VTK's messages are kept once, in one line, without their origin")
{
  vtkNew<vtkMessageCollector> messages;
  messages->Install();
  vtkNew<vtkImageData> object;
  for (int i = 0; i < 2; ++i)
  {
    vtkErrorWithObjectMacro(object, "It broke:\n  badly.");
    vtkWarningWithObjectMacro(object, "Mind this.");
    vtkGenericWarningMacro("And that.");
  }
  CHECK(messages->GetErrors() == std::vector<std::string>{ "It broke: badly." });
  CHECK(messages->GetWarnings() == std::vector<std::string>{ "Mind this.", "And that." });
  vtkOutputWindow::SetInstance(nullptr);
}
