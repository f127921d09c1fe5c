#include "StabilityCases.h"

#include "StudyVolumes.h"

#include <vtkImageData.h>

#include <cmath>
#include <limits>

namespace penumbra
{
namespace
{
using Json = nlohmann::ordered_json;

// What is refused has no error.
constexpr double Refused = -1.0;
// Rounding to 8 bits, and steps of half a voxel.
constexpr double Close = 1.0;
// Where the steps that are asked for cannot follow the opacity function, or the volume is cut off
// by less than a step: no more than is seen.
constexpr double Coarse = 4.0;

Json BaseScene(const std::string& volume)
{
  return Json::parse(R"({ "volume": { "file": ")" + volume + R"(.vti" },
    "transferFunction": { "opacity": [[40,0],[110,0.25],[255,0.6]],
      "color": [[0,0.9,0.3,0.2],[128,0.9,0.6,0.4],[255,1,1,0.9]], "opacityUnitDistance": 1 },
    "material": { "ambient": 0.2, "diffuse": 0.7, "specular": 0.3, "specularPower": 20 },
    "lights": [{ "type": "directional", "direction": [-0.6,-0.7,-0.4], "shadow": "soft" }],
    "camera": { "position": [37,30,62], "focalPoint": [11.5,11.5,11.5], "viewUp": [0,1,0],
      "viewAngle": 28 },
    "image": { "size": [48,48] } })");
}

class CaseList
{
public:
  /// `changes` is put over the base scene (RFC 7396).
  void Add(const std::string& name, const std::string& changes, double bound = Close,
    const std::string& volume = "balls")
  {
    StabilityCase added{ name, BaseScene(volume), bound };
    added.Scene.merge_patch(Json::parse(changes));
    this->Cases.push_back(added);
  }

  std::vector<StabilityCase> Cases;
};

std::string Opacity(const std::string& points, const std::string& unitDistance = "1")
{
  return R"({ "transferFunction": { "opacity": )" + points + R"(, "opacityUnitDistance": )" +
    unitDistance + "} }";
}

void AddOpacities(CaseList& list)
{
  for (const std::string a : { "0", "1e-8", "1e-4", "0.5", "0.9999", "0.99999999", "1" })
  {
    list.Add("opacity " + a, Opacity("[[40,0],[110," + a + "],[255," + a + "]]"), Coarse);
  }
  list.Add("unit distance 1e-6", Opacity("[[40,0],[255,1e-6]]", "1e-6"), Coarse);
  list.Add("unit distance 1e6", Opacity("[[40,0],[255,0.9]]", "1e6"));
  list.Add(
    "optical depth 1e4 in a step", Opacity("[[40,0],[110,0.99999],[255,0.99999]]", "5e-4"), Coarse);
  list.Add("jump between two values", Opacity("[[127,0],[128,1]]"), Coarse);
  list.Add("step in the function", Opacity("[[128,0],[128,0.7]]"), Coarse);
  for (const std::string width : { "1", "2", "4" })
  {
    list.Add("peak " + width + " wide of 65536",
      Opacity(
        "[[30000,0],[3000" + width + ",0.9],[3000" + std::to_string(2 * std::stoi(width)) + ",0]]"),
      Coarse, "wide");
  }
}

void AddSteps(CaseList& list)
{
  list.Add("steps of 1/64 voxel", R"({ "sampleDistance": 0.015625,
    "shadows": { "sampleDistance": 0.25 } })");
  list.Add("steps longer than the volume", R"({ "sampleDistance": 1000 })", 255.0);
  list.Add("sample distance 0", R"({ "sampleDistance": 0 })", Refused);
  list.Add("sample distance -1", R"({ "sampleDistance": -1 })", Refused);
  list.Add("sample distance no number", R"({ "sampleDistance": "NaN" })", Refused);
}

// A scene stretched by a factor shows the same picture; what has a length is stretched with it.
Json Scaled(double factor, double offset)
{
  const auto place = [=](double x, double y, double z) {
    return Json{ offset + factor * x, offset + factor * y, offset + factor * z };
  };
  return { { "transferFunction", { { "opacityUnitDistance", factor } } },
    { "camera",
      { { "position", place(37.0, 30.0, 62.0) }, { "focalPoint", place(11.5, 11.5, 11.5) } } } };
}

void AddSizes(CaseList& list)
{
  list.Add("scene of 1e-6", Scaled(1e-6, 0.0).dump(), Close, "tiny");
  list.Add("scene of 1e6", Scaled(1e6, 0.0).dump(), Close, "huge");
  list.Add("origin at 1e6", Scaled(1.0, 1e6).dump(), Close, "far");
  list.Add("spacing 1:1:1000", R"({ "transferFunction": { "opacityUnitDistance": 30 },
    "camera": { "position": [60,50,-3000], "focalPoint": [11.5,11.5,11500], "viewAngle": 1 } })",
    Coarse, "long");
  list.Add("one slice", "{}", Close, "slice");
  list.Add("two voxels", R"({ "camera": { "position": [4,3,6], "focalPoint": [0.5,0,0] } })", Close,
    "pair");
  list.Add("one voxel", R"({ "camera": { "position": [4,3,6], "focalPoint": [0,0,0] } })", Close,
    "single");
  list.Add("8192 by 1 pixels", R"({ "image": { "size": [8192,1] } })", Coarse);
  list.Add("1 by 8192 pixels", R"({ "image": { "size": [1,8192] } })", Coarse);
}

void AddValues(CaseList& list)
{
  list.Add("constant volume", "{}", Close, "constant");
  list.Add("plateaus", "{}", Coarse, "plateaus");
  list.Add("a NaN voxel", "{}", Close, "nan");
  list.Add("infinite voxels", "{}", Close, "infinite");
  list.Add("a voxel of 1e30", "{}", Coarse, "outlier");
  list.Add("uint16, full range", Opacity("[[10000,0],[28000,0.25],[65535,0.6]]"), Close, "wide");
  list.Add("int32, full range",
    R"({ "transferFunction": { "opacity": [[-1400000000,0],[-300000000,0.25],[2147483647,0.6]],
      "color": [[-2147483648,0.9,0.3,0.2],[0,0.9,0.6,0.4],[2147483647,1,1,0.9]] } })",
    Close, "int32");
  list.Add("double", "{}", Close, "double");
}

std::string Light(const std::string& members)
{
  return R"({ "lights": [{ "ambient": [0.5,0.5,0.5], )" + members + "}] }";
}

std::string ManyLights(int count)
{
  Json lights = Json::array();
  for (int light = 0; light < count; ++light)
  {
    const double angle = 0.7 * light;
    lights.push_back({ { "type", "directional" },
      { "direction", { std::cos(angle), std::sin(angle), -0.5 } }, { "intensity", 1.0 / count } });
  }
  return Json{ { "lights", lights } }.dump();
}

void AddLights(CaseList& list)
{
  const std::string soft = R"("type": "point", "shadow": "soft", )";
  list.Add("light at a voxel", Light(soft + R"("position": [12,12,12])"));
  list.Add("light in the volume", Light(soft + R"("position": [15.3,16.1,20.7])"));
  list.Add("light on a face", Light(soft + R"("position": [11.5,11.5,23])"));
  list.Add("light at 1e9", Light(soft + R"("position": [6e8,7e8,4e8])"));
  list.Add("64 lights", ManyLights(64));
  list.Add("black light", Light(R"("diffuse": [0,0,0], "specular": [0,0,0], "shadow": "soft")"));
  list.Add(
    "attenuation 0, 0, 0", Light(soft + R"("position": [30,30,40], "attenuation": [0,0,0])"));
  list.Add("no direction", Light(R"("type": "spot", "direction": [0,0,0])"), Refused);
  list.Add("cone of 0",
    Light(R"("type": "spot", "position": [30,30,40], "direction": [-1,-1,-1.5], "coneAngle": 0)"));
  list.Add("cone of 180",
    Light(
      R"("type": "spot", "position": [30,30,40], "direction": [-1,-1,-1.5], "coneAngle": 180)"));
  const std::string key = R"("direction": [-0.6,-0.7,-0.4], )";
  list.Add("bias 0", Light(key + R"("shadow": "soft", "shadowBias": 0)"));
  list.Add("bias 1e4", Light(key + R"("shadow": "soft", "shadowBias": 1e4)"));
  // The light ends where matter begins to be seen, within less than a step.
  Json fine = Json::parse(Light(key + R"("shadow": "hard", "opacityThreshold": 0)"));
  fine["sampleDistance"] = 0.05;
  list.Add("threshold 0", fine.dump());
  list.Add("threshold 1", Light(key + R"("shadow": "hard", "opacityThreshold": 1)"), Coarse);
}

void AddMaterials(CaseList& list)
{
  list.Add("specular power 0", R"({ "material": { "specularPower": 0 } })");
  list.Add("specular power 1e6", R"({ "material": { "specularPower": 1e6 } })", Coarse);
  for (const std::string model :
    { "phong", "blinn-phong", "oren-nayar", "ward", "ward-anisotropic", "cook-torrance" })
  {
    list.Add("grazing light and view, " + model,
      R"({ "material": { "model": ")" + model + R"(", "diffuse": 0.4 },
        "lights": [{ "direction": [-1,-0.02,0], "shadow": "none" }],
        "camera": { "position": [70,13.5,11.5], "focalPoint": [11.5,11.5,11.5], "viewUp": [0,1,0] } })",
      Coarse, "floor");
  }
}

void AddViews(CaseList& list)
{
  list.Add("camera inside", R"({ "camera": { "position": [12,13,20], "focalPoint": [12,12,2],
    "viewAngle": 70 } })");
  list.Add("parallel projection along an axis", R"({ "camera": { "position": [11.5,11.5,80],
    "focalPoint": [11.5,11.5,11.5], "viewUp": [0,1,0], "parallelScale": 14 } })");
  list.Add("clipping plane through the light",
    R"({ "clippingPlanes": [{ "origin": [15,16,20], "normal": [0,0,-1] }],
      "lights": [{ "type": "point", "position": [15,16,20], "shadow": "soft" }] })");
}

double Smallest(const std::array<int, 3>& dimensions)
{
  return 2.0 / (dimensions[0] - 1);
}
}

//------------------------------------------------------------------------------
std::vector<StabilityCase> GetStabilityCases()
{
  CaseList list;
  AddOpacities(list);
  AddSteps(list);
  AddSizes(list);
  AddValues(list);
  AddLights(list);
  AddMaterials(list);
  AddViews(list);
  return list.Cases;
}

//------------------------------------------------------------------------------
void WriteStabilityVolumes(const std::filesystem::path& folder)
{
  std::filesystem::create_directories(folder);
  const std::array<int, 3> size = { 24, 24, 24 };
  const double voxel = Smallest(size);
  const auto write = [&](const std::string& name, const StudyGrid& grid, const StudyField& field)
  { WriteStudyVolume(MakeStudyVolume(grid, field), folder / (name + ".vti")); };
  // One voxel in the middle of the balls, and the rest of them.
  const auto balls = [voxel](double value)
  {
    return [voxel, value](double x, double y, double z)
    {
      const bool inMiddle = std::abs(x) < voxel && std::abs(y) < voxel && std::abs(z - 0.3) < voxel;
      return inMiddle ? value : TwoBalls(x, y, z);
    };
  };
  const auto stretched = [](double low, double high)
  {
    return [low, high](double x, double y, double z)
    { return low + (high - low) * TwoBalls(x, y, z) / 255.0; };
  };
  write("balls", { size }, TwoBalls);
  write("floor", { size }, FloorAndBar);
  write("wide", { size, { 1, 1, 1 }, { 0, 0, 0 }, VTK_UNSIGNED_SHORT }, stretched(0.0, 65535.0));
  write(
    "int32", { size, { 1, 1, 1 }, { 0, 0, 0 }, VTK_INT }, stretched(-2147483648.0, 2147483647.0));
  write("double", { size, { 1, 1, 1 }, { 0, 0, 0 }, VTK_DOUBLE }, TwoBalls);
  write("tiny", { size, { 1e-6, 1e-6, 1e-6 }, { 0, 0, 0 }, VTK_FLOAT }, TwoBalls);
  write("huge", { size, { 1e6, 1e6, 1e6 } }, TwoBalls);
  write("far", { size, { 1, 1, 1 }, { 1e6, 1e6, 1e6 } }, TwoBalls);
  write("long", { size, { 1, 1, 1000 } }, TwoBalls);
  write("slice", { { 24, 24, 1 } }, TwoBalls);
  write("pair", { { 2, 1, 1 } }, [](double, double, double) { return 150.0; });
  write("single", { { 1, 1, 1 } }, [](double, double, double) { return 150.0; });
  write("constant", { size }, [](double, double, double) { return 90.0; });
  write(
    "plateaus", { size }, [](double x, double, double z) { return x + z > 0.0 ? 200.0 : 90.0; });
  const double infinity = std::numeric_limits<double>::infinity();
  const StudyGrid floats{ size, { 1, 1, 1 }, { 0, 0, 0 }, VTK_FLOAT };
  write("nan", floats, balls(std::numeric_limits<double>::quiet_NaN()));
  write("infinite", floats, balls(infinity));
  write("outlier", floats, balls(1e30));
}

}
