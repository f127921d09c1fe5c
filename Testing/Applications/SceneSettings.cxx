#include "SceneSettings.h"

#include "Catch.h"
#include "InputError.h"
#include "SceneFile.h"

#include <nlohmann/json.hpp>

using namespace penumbra;
using Json = nlohmann::json;

namespace
{
Json Set(const std::string& scene, const std::string& setting)
{
  Json json = ParseJson(scene);
  ApplySetting(json, setting);
  return json;
}
}

TEST_CASE("A setting overrides or adds a key")
{
  CHECK(Set(R"({ "shade": true })", "shade=false") == ParseJson(R"({ "shade": false })"));
  CHECK(Set("{}", "sampleDistance=0.25") == ParseJson(R"({ "sampleDistance": 0.25 })"));
  CHECK(Set("{}", "image.size=[256,128]") == ParseJson(R"({ "image": { "size": [256,128] } })"));
  CHECK(Set(R"({ "lights": [{}, {}] })", "lights.1.shadow=hard") ==
    ParseJson(R"({ "lights": [{}, { "shadow": "hard" }] })"));
}

TEST_CASE("A setting's value is JSON or a bare word")
{
  CHECK(Set("{}", "a=true")["a"] == true);
  CHECK(Set("{}", "a=1e3")["a"] == 1000.0);
  CHECK(Set("{}", "a=\"1\"")["a"] == "1");
  CHECK(Set("{}", "a=vtk")["a"] == "vtk");
  CHECK(Set("{}", "a=folder/with space=and.json")["a"] == "folder/with space=and.json");
  CHECK(Set("{}", "a=")["a"] == "");
  CHECK(Set("{}", "a=NaN")["a"] == "NaN");
  CHECK_THROWS_AS(Set("{}", "a=[1,2"), InputError);
  CHECK_THROWS_AS(Set("{}", "a={\"b\": 1, \"b\": 2}"), InputError);
}

TEST_CASE("A setting can add one entry to an array")
{
  CHECK(Set(R"({ "lights": [] })", "lights.0.type=point") ==
    ParseJson(R"({ "lights": [{ "type": "point" }] })"));
  CHECK_THROWS_WITH(Set(R"({ "lights": [{}] })", "lights.2.type=point"),
    Catch::Matchers::ContainsSubstring("lights.2"));
  CHECK_THROWS_WITH(Set(R"({ "lights": [{}] })", "lights.key.type=point"),
    Catch::Matchers::ContainsSubstring("lights.key"));
}

TEST_CASE("A setting within an absent array changes its default")
{
  CHECK(Set("{}", "lights.0.shadow=soft") ==
    ParseJson(R"({ "lights": [{ "type": "headlight", "shadow": "soft" }] })"));
  CHECK(Set("{}", "lights.1.type=point")["lights"].size() == 2);
  CHECK(Set("{}", "image.size.1=256")["image"]["size"] == ParseJson("[512,256]"));
  CHECK(Set(R"({ "lights": [{}] })", "lights.0.direction.0=1")["lights"][0]["direction"] ==
    ParseJson("[1,0,-1]"));
}

TEST_CASE("A setting that fits no scene is refused")
{
  const auto setting =
    GENERATE(values<std::string>({ "shade", "=1", ".a=1", "a..b=1", "a.=1", "", "renderer.x=1" }));
  CHECK_THROWS_WITH(
    Set(R"({ "renderer": "vtk" })", setting), Catch::Matchers::ContainsSubstring(setting));
}

TEST_CASE("A setting is UTF-8 and nests as deep as scene files may")
{
  CHECK(Set("{}", "lights.0.name=\xc3\xa9")["lights"][0]["name"] == "\xc3\xa9");
  CHECK_THROWS_AS(Set("{}", "lights.0.name=\xff"), InputError);
  CHECK_THROWS_AS(Set("{}", "\xff=1"), InputError);

  std::string path = "a";
  for (int depth = 1; depth < 60000; ++depth)
  {
    path += ".a";
  }
  CHECK_NOTHROW(Set("{}", path.substr(0, 199) + "=1"));
  CHECK_THROWS_AS(Set("{}", path.substr(0, 201) + "=1"), InputError);
  CHECK_THROWS_AS(Set("{}", path + "=1"), InputError);
}

TEST_CASE("A long setting is shortened in messages")
{
  for (const std::string& setting : { "a=" + std::string(30000, '['), std::string(30000, 'a') })
  {
    try
    {
      Set("{}", setting);
      FAIL("was accepted");
    }
    catch (const InputError& error)
    {
      CHECK(std::string(error.what()).size() < 300);
    }
  }
}
