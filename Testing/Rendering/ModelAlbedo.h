/**
 * @file ModelAlbedo.h
 * @brief What each of the shader's reflection models reflects in all, as ReflectionModels.md has
 * it.
 */
#ifndef ModelAlbedo_h
#define ModelAlbedo_h

#include "ReflectionGeometry.h"

#include <string>
#include <vector>

/// Enough for an error of 5e-4, relative to 1 or to the albedo where that is more.
constexpr int AlbedoPoints = 32768;

/// A and B, as the mapper passes them.
shader::vec4 OrenNayarParameters(double roughness);

/// Integral of F_d / pi over all directions of light, by the eye's angle to the normal in degrees.
double OrenNayarAlbedo(double roughness, double degrees, int points = AlbedoPoints);

/// Integrals of F_s / pi.
double PhongAlbedo(double power, double degrees, int points = AlbedoPoints);
double BlinnPhongAlbedo(double power, double degrees, int points = AlbedoPoints);

/// Integrals of F_s; the eye is in the plane of N and P where it looks along the strokes.
double WardAlbedo(double roughness, double degrees, int points = AlbedoPoints);
double WardAlbedoAlong(double x, double y, double degrees, int points = AlbedoPoints);
double WardAlbedoAcross(double x, double y, double degrees, int points = AlbedoPoints);

/// Integrals of F_s, with F = 1 for an index of refraction of 0.
double BeckmannAlbedo(double slope, double n, double degrees, int points = AlbedoPoints);
double GaussianAlbedo(double slope, double constant, double degrees, int points = AlbedoPoints);

/// A table of the document: the heading of its first column, and what its rows hold.
struct AlbedoTable
{
  std::string Heading;
  double (*Compute)(const std::vector<double>& parameters, double degrees, int points);
};

const std::vector<AlbedoTable>& AlbedoTables();

#endif
