#include "Catch.h"
#include "PictureLook.h"
#include "RunProgram.h"

#include <filesystem>

using namespace penumbra;
using Catch::Matchers::WithinAbs;

namespace
{
const std::string Data = PENUMBRA_DATA;
constexpr double LeastForeground = 0.12;
// Vessels and stents are thin.
constexpr double LeastThinForeground = 0.08;

struct Sample
{
  std::string volume;
  std::string preset;
  double leastForeground;
};

void CheckSample(const Sample& sample)
{
  INFO(sample.preset << " on " << sample.volume);
  CheckIsSeen(LookOf({ sample.volume, "--preset", sample.preset }), sample.leastForeground);
}

void CheckFetched(const std::string& volume, const std::string& preset)
{
  if (!std::filesystem::exists(volume))
  {
    SKIP("there is no " + volume + "; Data/fetch-data.sh brings it");
  }
  CheckSample({ volume, preset, LeastForeground });
}
}

TEST_CASE("A volume alone gives a picture in which something is seen")
{
  CheckIsSeen(LookOf({ Data + "/brainsmall.mhd" }), LeastForeground);
  CheckIsSeen(LookOf({ Data + "/mr-brain" }), LeastForeground);
  CheckIsSeen(LookOf({ Data + "/stent.mhd" }), LeastThinForeground);
}

TEST_CASE("Presets for MR and for any data show the shipped volumes well")
{
  const std::string brain = Data + "/brainsmall.mhd";
  const std::string head = Data + "/mr-brain";
  const std::string stent = Data + "/stent.mhd";
  CheckSample(GENERATE_COPY(values<Sample>({
    { brain, "mr-head", LeastForeground },
    { head, "mr-head", LeastForeground },
    { brain, "mr-brain", LeastForeground },
    { head, "mr-brain", LeastForeground },
    { stent, "mr-angiography", LeastThinForeground },
    { brain, "surface", LeastForeground },
    { head, "surface", LeastForeground },
    { stent, "surface", LeastThinForeground },
    { brain, "cloud", LeastForeground },
    { head, "cloud", LeastForeground },
  })));
}

TEST_CASE("The chest's presets show the CT chest well")
{
  CheckFetched(Data + "/fetched/ct-chest",
    GENERATE(values<std::string>({ "ct-bone", "ct-skin", "ct-skin-bone", "ct-lung", "ct-vessels",
      "ct-abdomen", "ct-muscle" })));
}

TEST_CASE("The head's presets show the CT head well")
{
  CheckFetched(Data + "/fetched/ct-head/ct-head.mhd",
    GENERATE(values<std::string>({ "ct-bone", "ct-skin", "ct-skin-bone" })));
}

TEST_CASE("The shipped scenes show their volumes")
{
  const auto scene = GENERATE(values<std::string>({ "stent", "brain" }));
  INFO(scene);
  const PictureLook look = LookOf({ Data + "/" + scene + ".json" });
  CHECK(look.foreground > LeastThinForeground);
  CHECK(look.report["warnings"].empty());
  CHECK(look.report["technique"] != "none");
}

TEST_CASE("The thesis' scenes show their volumes, where they are there, with and without shadows")
{
  const auto scene = GENERATE(values<std::string>({ "ct", "skull", "bonsai", "engine" }));
  const std::string file = Data + "/thesis/" + scene + ".json";
  const auto description = nlohmann::json::parse(ReadAll(file));
  const std::string volume = Data + "/thesis/" + description["volume"]["file"].get<std::string>();
  if (!std::filesystem::exists(volume))
  {
    SKIP("there is no " + volume);
  }
  INFO(scene);
  const PictureLook lit = LookOf({ file });
  const PictureLook soft = LookOf({ file, "--set", "lights.0.shadow=soft" });
  const PictureLook hard = LookOf({ file, "--set", "lights.0.shadow=hard" });
  CHECK(lit.foreground > LeastForeground);
  CHECK(lit.luminance > 0.25);
  CHECK(soft.luminance < lit.luminance);
  CHECK(hard.luminance < lit.luminance);
}

TEST_CASE("The report tells how bright the picture is")
{
  const PictureLook look = LookOf({ Data + "/brainsmall.mhd", "--set", "lights.0.intensity=9" });
  REQUIRE(look.burntOut > 0.0);
  const nlohmann::json told = look.report["brightness"];
  // Both add up the same eight-bit values in double precision; one by way of 32-bit files.
  constexpr double roundOff = 1e-6;
  CHECK_THAT(told["foreground"].get<double>(), WithinAbs(look.foreground, roundOff));
  CHECK_THAT(told["luminance"].get<double>(), WithinAbs(look.luminance, roundOff));
  CHECK_THAT(told["burntOut"].get<double>(), WithinAbs(look.burntOut, roundOff));
  CHECK_THAT(told["black"].get<double>(), WithinAbs(look.black, roundOff));
}

TEST_CASE("A picture of nothing has no brightness")
{
  const TemporaryFolder folder;
  const auto result = RunPenumbraRender(
    { Data + "/brainsmall.mhd", "--set", "transferFunction.opacity=[[0,0],[255,0]]", "--set",
      "image.size=[16,16]", "--report", folder.PathOf("r.json") });
  REQUIRE(result.exitStatus == 0);
  const auto told = nlohmann::json::parse(ReadAll(folder.PathOf("r.json")))["brightness"];
  CHECK(told ==
    nlohmann::json{
      { "foreground", 0.0 }, { "luminance", 0.0 }, { "burntOut", 0.0 }, { "black", 0.0 } });
}
