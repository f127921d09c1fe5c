#include "Catch.h"
#include "RenderProgram.h"
#include "StudyScenes.h"
#include "TemporaryFolder.h"

using namespace penumbra;

TEST_CASE("Every default scene is within a grey level of the reference at half a voxel")
{
  const TemporaryFolder folder;
  const auto scenes = WriteDefaultScenes(folder.PathOf(""), folder.PathOf("nothing"));
  CHECK(scenes.size() == 7);
  const RenderProgram program(PENUMBRA_RENDER, folder.PathOf(""));
  const std::string technique = GENERATE("rays", "auto");
  for (const StudyScene& scene : scenes)
  {
    const std::vector<std::string> settings = { "image.size=[48,48]", "sampleDistance=0.5",
      "shadows.technique=" + technique };
    std::vector<std::string> reference = settings;
    reference.push_back("renderer=reference");
    INFO(scene.Name << " by " << technique);
    const RenderResult expected = program.Run({ scene.File, reference });
    const RenderResult rendered = program.Run({ scene.File, settings });
    REQUIRE(expected.End == RenderEnd::Done);
    REQUIRE(rendered.End == RenderEnd::Done);
    const PictureError error = CompareWithReference(*rendered.Picture, *expected.Picture);
    CHECK(error.RootMeanSquare < 1.0);
    CHECK(error.RootMeanSquare > 0.0);
  }
}

TEST_CASE("Lit steps that a steep function cuts count their pieces")
{
  const TemporaryFolder folder;
  const StudyScene scene = WriteAnalyticScene("steep", 64, folder.PathOf(""));
  const RenderProgram program(PENUMBRA_RENDER, folder.PathOf(""));
  const std::vector<std::string> settings = { "image.size=[48,48]", "lights.0.shadow=none",
    "sampleDistance=0.6" };
  std::vector<std::string> reference = settings;
  reference.push_back("renderer=reference");
  const RenderResult expected = program.Run({ scene.File, reference });
  const RenderResult rendered = program.Run({ scene.File, settings });
  REQUIRE(expected.End == RenderEnd::Done);
  REQUIRE(rendered.End == RenderEnd::Done);
  // Pieces come to 2.7; pieces that are lit in the middle of their step to 3.6.
  CHECK(CompareWithReference(*rendered.Picture, *expected.Picture).RootMeanSquare < 3.0);
}

TEST_CASE("Scenes of one name are told apart")
{
  const auto scenes = NameScenes({ "a/x.json", "b/x.json", "c/y.json" });
  CHECK(scenes[0].Name == "x");
  CHECK(scenes[1].Name == "x-2");
  CHECK(scenes[2].Name == "y");
}
