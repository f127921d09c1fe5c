#include "Catch.h"
#include "ResolvedScene.h"
#include "SceneDefaults.h"
#include "SceneFile.h"
#include "SceneParser.h"
#include "SceneVolume.h"
#include "SyntheticVolumes.h"

#include <nlohmann/json.hpp>

#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkPlaneCollection.h>

#include <sstream>
#include <string>
#include <vector>

using namespace penumbra;

namespace
{
// All that a mapper was told, as it prints it.
std::vector<std::string> SettingsOf(vtkGPUVolumeRayCastMapper* mapper)
{
  std::ostringstream text;
  mapper->Print(text);
  std::istringstream lines(text.str());
  std::vector<std::string> settings;
  for (std::string line; std::getline(lines, line);)
  {
    for (const char* name :
      { "Shadow", "Gradient", "SkipEmptySpace", "OpticalModel", "SampleDistance", "Cropping:" })
    {
      if (line.find(name) != std::string::npos)
      {
        settings.push_back(line);
      }
    }
  }
  return settings;
}
}

TEST_CASE("A scene that a mapper is given leaves nothing of the one before")
{
  const auto volume = MakeBall({}, 9.0, 2.0);
  const SceneDescription plain = Resolve("", volume);
  SceneDescription other = Resolve(R"(, "sampleDistance": 0.25, "skipEmptySpace": false,
    "opticalModel": "emission", "shade": false, "gradient": "sobel", "gradientTexture": 8,
    "clippingPlanes": [{}], "shadows": { "technique": "volume", "sampleDistance": 0.75,
    "resolution": 0.5, "nearSteps": 7, "tolerance": 3 })",
    volume);
  other.Volume.Cropping = { 1.0, 2.0, 3.0, 4.0, 5.0, 6.0 };
  std::vector<std::string> warnings;
  const auto fresh = MakeMapper(plain, { volume, nullptr }, warnings);
  const auto mapper = MakeMapper(other, { volume, nullptr }, warnings);
  REQUIRE(SettingsOf(mapper).size() > 10);
  CHECK(SettingsOf(mapper) != SettingsOf(fresh));
  CHECK(mapper->GetClippingPlanes()->GetNumberOfItems() == 1);
  ApplyToMapper(plain, mapper, warnings);
  CHECK(SettingsOf(mapper) == SettingsOf(fresh));
  CHECK(mapper->GetClippingPlanes()->GetNumberOfItems() == 0);
}
