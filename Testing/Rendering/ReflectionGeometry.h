/**
 * @file ReflectionGeometry.h
 * @brief Directions that light is reflected between, and what the shader knows of them.
 */
#ifndef ReflectionGeometry_h
#define ReflectionGeometry_h

#include "ShaderMathematics.h"

#include <array>
#include <random>

using Vector = std::array<double, 3>;

double Dot(const Vector& a, const Vector& b);
Vector Cross(const Vector& a, const Vector& b);
Vector Sum(double a, const Vector& u, double b, const Vector& v); ///< a u + b v
double Length(const Vector& vector);
Vector Normalized(const Vector& vector);

/// A direction by its angle from z and its azimuth from x, in degrees.
Vector AtAngles(double polar, double azimuth = 0.0);

Vector RandomDirection(std::mt19937& generator);

/// Unit vectors: the normal, to the light, to the eye, and along the brush strokes.
struct ReflectionDirections
{
  Vector N = { 0.0, 0.0, 1.0 };
  Vector L = { 0.0, 0.0, 1.0 };
  Vector V = { 0.0, 0.0, 1.0 };
  Vector P = { 1.0, 0.0, 0.0 };
};

/// All of them anywhere.
ReflectionDirections RandomDirections(std::mt19937& generator);

/// L mirrors V at facets whose slope against N is mostly below the given one; it can be lit or not.
ReflectionDirections RandomHighlight(std::mt19937& generator, double slope);

/// Light and eye change places.
ReflectionDirections Reversed(const ReflectionDirections& directions);

shader::ReflectionCosines CosinesOf(const ReflectionDirections& directions);

#endif
