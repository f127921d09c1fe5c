/**
 * @file BrightCorner.h
 * @brief A small scene in a folder of its own: a bright corner on dark blue.
 */
#ifndef BrightCorner_h
#define BrightCorner_h

#include "TemporaryFolder.h"

#include <string>

namespace penumbra
{
/// 8x8x8 voxels, dense and white where x and y are large; seen from +z with y up, that is the
/// picture's upper right.
struct BrightCorner : TemporaryFolder
{
  BrightCorner()
  {
    std::string voxels;
    for (int voxel = 0; voxel < 512; ++voxel)
    {
      const int x = voxel % 8;
      const int y = voxel / 8 % 8;
      voxels += x >= 5 && y >= 5 ? '\xff' : '\0';
    }
    this->Write("corner.raw", voxels);
    this->Scene = this->Write("scene.json", R"({
      "volume": { "file": "corner.raw", "dimensions": [8,8,8], "scalarType": "uint8" },
      "transferFunction": { "opacity": [[0,0],[255,0.9]], "color": [[0,1,1,1]] },
      "shade": false,
      "camera": { "position": [3.5,3.5,30], "focalPoint": [3.5,3.5,3.5], "viewUp": [0,1,0] },
      "image": { "size": [48,32], "background": [0,0,0.4] } })");
  }

  std::string Scene;
};
}

#endif
