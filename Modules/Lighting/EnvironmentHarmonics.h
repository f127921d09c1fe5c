/**
 * @file    EnvironmentHarmonics.h
 * @brief   blurring over the sphere, by spherical harmonics
 *
 * A kernel that depends only on the angle to its axis multiplies each spherical harmonic of degree
 * l by one factor (Funk and Hecke). So a blur costs the same however wide it is, and it is exact
 * but for the degrees that are left out.
 */

#ifndef EnvironmentHarmonics_h
#define EnvironmentHarmonics_h

#include <array>
#include <cstddef>
#include <vector>

namespace penumbra
{

/// Values in the directions of polar angle (ring + 1/2) pi / Rings from +y and azimuth
/// 2 pi (column + 1/2) / Columns - pi, atan2(z, x). Ring by ring.
struct SphereGrid
{
  /// A power of two, at least 16; twice as many columns as rings.
  int Columns = 0;
  int Rings = 0;
  std::vector<std::array<double, 3>> Values;

  explicit SphereGrid(int columns)
    : Columns(columns)
    , Rings(columns / 2)
    , Values(static_cast<std::size_t>(columns) * (columns / 2))
  {
  }
};

/**
 * The factors of the kernel max(cos, 0)^n / integral of max(cos, 0)^n, from degree 0 on:
 *   f(l) = integral from 0 to 1 of t^n P_l(t) dt / integral from 0 to 1 of t^n dt.
 * As many as it takes for the others to change no result by more than a twentieth of an 8-bit step
 * where values are between 0 and 1, but at most 385. For n < 1, whose kernel has an edge, those are
 * too few by that bound; with a sky of one half bright, n = 0, they are 0.4 steps off.
 */
std::vector<double> ComputeLobeFactors(double power);

/**
 * From fluxes, value times solid angle, to values: their convolution with the kernel of these
 * factors. There are at least four columns for each factor.
 */
void Convolve(SphereGrid& grid, const std::vector<double>& factors);

}

#endif
