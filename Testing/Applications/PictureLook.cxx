#include "PictureLook.h"

#include "Catch.h"
#include "RunProgram.h"

#include <algorithm>
#include <cstring>

using namespace penumbra;

namespace
{
// Colour and opacity of each pixel, over black.
std::vector<float> PixelsOf(const std::string& mha)
{
  const std::string bytes = ReadAll(mha);
  const std::string end = "ElementDataFile = LOCAL\n";
  const auto begin = bytes.find(end) + end.size();
  std::vector<float> pixels((bytes.size() - begin) / sizeof(float));
  std::memcpy(pixels.data(), bytes.data() + begin, pixels.size() * sizeof(float));
  return pixels;
}
}

//------------------------------------------------------------------------------
PictureLook LookOf(std::vector<std::string> arguments)
{
  const TemporaryFolder folder;
  arguments.insert(arguments.end(),
    { "--set", "image.size=[128,128]", "--output", folder.PathOf("p.mha"), "--report",
      folder.PathOf("r.json") });
  const auto result = RunPenumbraRender(arguments);
  INFO(result.error);
  REQUIRE(result.exitStatus == 0);
  const auto pixels = PixelsOf(folder.PathOf("p.mha"));
  PictureLook look;
  look.report = nlohmann::json::parse(ReadAll(folder.PathOf("r.json")));
  double count = 0.0;
  for (std::size_t at = 0; at < pixels.size(); at += 4)
  {
    const float* p = &pixels[at];
    if (p[3] > 0.03f)
    {
      const double luminance = 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
      count += 1.0;
      look.luminance += luminance;
      look.burntOut += std::max({ p[0], p[1], p[2] }) >= 0.995f ? 1.0 : 0.0;
      look.black += luminance < 0.05 ? 1.0 : 0.0;
    }
  }
  REQUIRE(count > 0.0);
  look.foreground = 4.0 * count / static_cast<double>(pixels.size());
  look.luminance /= count;
  look.burntOut /= count;
  look.black /= count;
  return look;
}

//------------------------------------------------------------------------------
void CheckIsSeen(const PictureLook& look, double leastForeground)
{
  INFO("foreground " << look.foreground << ", luminance " << look.luminance << ", burnt "
                     << look.burntOut << ", black " << look.black);
  CHECK(look.foreground > leastForeground);
  CHECK(look.luminance > 0.25);
  CHECK(look.luminance < 0.7);
  CHECK(look.burntOut < 0.02);
  CHECK(look.black < 0.1);
}
