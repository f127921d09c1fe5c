#include "SpeedScenes.h"

#include "SceneFile.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace penumbra
{
namespace
{
namespace fs = std::filesystem;

struct FetchedScene
{
  const char* Name;
  /// Below the data.
  const char* File;
  /// Below the fetched volumes.
  const char* Volume;
  bool HasBounds;
  bool HasAxes;
};

const FetchedScene FetchedScenes[] = {
  { "bonsai", "thesis/bonsai.json", "bonsai.mhd", true, true },
  { "engine", "thesis/engine.json", "engine.mhd", true, false },
  { "aneurism", "speed/aneurism.json", "aneurism.mhd", true, false },
  { "headsq", "speed/headsq.json", "headsq.mhd", true, false },
  { "ct", "thesis/ct.json", "ct-chest", true, false },
  { "skull", "thesis/skull.json", "ct-head/ct-head.mhd", false, false },
};

// Nothing where the scene or its volume is not there.
std::optional<SpeedScene> Write(const FetchedScene& fetched, const SpeedSceneSource& source)
{
  const fs::path original = source.Data / fetched.File;
  const fs::path volume = source.Fetched / fetched.Volume;
  std::error_code ignored;
  if (!fs::exists(original, ignored) || !fs::exists(volume, ignored))
  {
    return std::nullopt;
  }
  nlohmann::json scene = ParseJson(ReadJsonFile(original));
  scene["volume"]["file"] = fs::absolute(volume).generic_u8string();
  const fs::path file = source.Folder / (std::string(fetched.Name) + ".json");
  WriteText(file, scene.dump(2) + "\n");
  return SpeedScene{ fetched.Name, file, fetched.HasBounds, fetched.HasAxes };
}

SpeedScene WriteMade(const std::string& name, int edge, const fs::path& folder)
{
  const StudyScene scene = WriteAnalyticScene(name, edge, folder);
  return { scene.Name, scene.File };
}
}

//------------------------------------------------------------------------------
SpeedSceneList WriteSpeedScenes(const SpeedSceneSource& source)
{
  fs::create_directories(source.Folder);
  SpeedSceneList list;
  for (const FetchedScene& fetched : FetchedScenes)
  {
    if (const auto scene = Write(fetched, source))
    {
      list.Scenes.push_back(*scene);
    }
    else
    {
      // Tables are published: they name no folder of the machine that made them.
      list.Notes.push_back(std::string(fetched.Name) + " is left out: there is no " +
        fetched.Volume + " among the fetched volumes");
    }
  }
  const bool anyHasBounds = std::any_of(list.Scenes.begin(), list.Scenes.end(),
    [](const SpeedScene& scene) { return scene.HasBounds; });
  for (const char* name : { "tree", "casting" })
  {
    SpeedScene scene = WriteMade(name, source.Edge, source.Folder);
    scene.HasBounds = !anyHasBounds;
    scene.HasAxes = !anyHasBounds || scene.Name == "tree";
    list.Scenes.push_back(scene);
  }
  list.Scenes.push_back(WriteMade("haze", source.Edge / 2, source.Folder));
  return list;
}

//------------------------------------------------------------------------------
std::vector<SpeedScene> NameSpeedScenes(const std::vector<fs::path>& files)
{
  std::vector<SpeedScene> scenes;
  for (const StudyScene& scene : NameScenes(files))
  {
    scenes.push_back({ scene.Name, scene.File, false, true });
  }
  return scenes;
}

}
