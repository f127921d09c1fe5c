/**
 * @file ReflectionAlbedo.h
 * @brief What a reflection model reflects in all: integrals over the directions of the light.
 *
 * All sum over a Fibonacci lattice, whose error falls at least with the 3/4th power of its number
 * of points, also in functions that end abruptly at the horizon. N is z, P is x.
 */
#ifndef ReflectionAlbedo_h
#define ReflectionAlbedo_h

#include "ReflectionGeometry.h"

#include <functional>

/// F_d or F_s.
using Reflection = std::function<double(const shader::ReflectionCosines&)>;

/// Integral of F over the hemisphere about the normal, for broad reflections.
double HemisphereIntegral(const Reflection& reflection, const Vector& view, int points);

/// The same, with points that are dense where the half vector's slope against the normal is about
/// the given one or less.
double HalfVectorIntegral(
  const Reflection& reflection, const Vector& view, double slope, int points);

/// The same of a reflection within 90 degrees of the mirrored view, with points that are as dense
/// as the power of that angle's cosine. The view is in the plane of x and z.
double MirrorIntegral(const Reflection& reflection, const Vector& view, double power, int points);

#endif
