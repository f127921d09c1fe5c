/**
 * @file    EnvironmentMap.h
 * @brief   light from all around, as one image or six, and what surfaces reflect of it
 *
 * An environment map gives the radiance E(w) that arrives from each direction w, +y up. Each
 * pixel's value holds over all of the pixel's solid angle. Two forms:
 *
 * - One equirectangular image, laid out as VTK's own: u = atan2(w.z, w.x) / 2 pi + 0.5 across and
 *   v = asin(w.y) / pi + 0.5 from the bottom up, so that the top row is +y, the vertical middle the
 *   horizon, the centre +x, and +z a quarter of the width to the right of it.
 * - Six square images of one size in the order +x, -x, +y, -y, +z, -z, laid out as OpenGL's cube
 *   maps: the left column is s = 0, the top row t = 0, s and t by the OpenGL specification's table.
 *   So +x shows +y at its top and +z at its left: the mirror image of what one sees from within.
 *
 * Surfaces reflect it blurred. The lobe of power n is the kernel max(R.w, 0)^n, about a Gaussian of
 * standard deviation 1 / sqrt(n + 1) radians. FilterDiffuse and FilterSpecular make cube maps
 * which, looked up with linear filtering across the faces' edges, are within half an 8-bit step of
 * the integral where the map's values are at most 1. Only between the outermost texels of two
 * faces, near the cube's corners, OpenGL's lookup itself is up to a quarter of a texel off: at most
 * another one and a half steps, where a sharp edge of the map falls there and the power is high.
 */

#ifndef EnvironmentMap_h
#define EnvironmentMap_h

#include "PenumbraLightingModule.h" // For export macro

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkImageData;

namespace penumbra
{

/// Linear radiance, red, green and blue pixel by pixel; the first row is the top one.
struct EnvironmentImage
{
  int Width = 0;
  int Height = 0;
  std::vector<float> Pixels;
};

/// As MakeEnvironmentMap makes it: one equirectangular image or six faces.
struct EnvironmentMap
{
  std::vector<EnvironmentImage> Images;
};

/// A cube map as OpenGL takes it: faces in the order +x, -x, +y, -y, +z, -z of Size by Size texels
/// of red, green and blue, the row of t = 0 first. Linear radiance.
struct CubeMap
{
  int Size = 0;
  std::array<std::vector<float>, 6> Faces;
};

/**
 * The map that one or six images show. Values count as linear radiance: 8-bit ones over 255, 16-bit
 * ones over 65535 (both unsigned), floating-point ones as they are. One component is grey, two are
 * grey and alpha, three red, green and blue, four with alpha; alpha is ignored. Images have
 * their bottom row first, as VTK's readers make them. Empty where the images are no such map;
 * `reason` then says why ("image 2 of 6 is not square (8 x 4)").
 */
PENUMBRALIGHTING_EXPORT std::optional<EnvironmentMap> MakeEnvironmentMap(
  const std::vector<vtkImageData*>& images, std::string& reason);

/// 1/(4 pi) times the integral of E(w) dw over all directions; red, green, blue.
PENUMBRALIGHTING_EXPORT std::array<double, 3> MeanRadiance(const EnvironmentMap& map);

/// What a diffuse surface of normal N reflects:
///   Ed(N) = 1/pi integral of E(w) max(N.w, 0) dw.
PENUMBRALIGHTING_EXPORT CubeMap FilterDiffuse(const EnvironmentMap& map);

/**
 * What a glossy surface reflects in the mirrored direction R:
 *   Es(R) = integral of E(w) max(R.w, 0)^n dw / integral of max(R.w, 0)^n dw, n = power >= 0;
 * for n = 0 the mean over the hemisphere about R. Powers above LargestFilteredPower count as it. Up
 * to 1000 the stated accuracy holds; beyond that the largest faces' texels sample the lobe more
 * coarsely, and fine detail is up to three 8-bit steps off.
 */
PENUMBRALIGHTING_EXPORT CubeMap FilterSpecular(const EnvironmentMap& map, double power);

/// A lobe of 0.9 degrees, four texels of the largest faces.
constexpr double LargestFilteredPower = 4096.0;

}

#endif
