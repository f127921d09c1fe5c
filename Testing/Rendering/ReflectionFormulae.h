/**
 * @file ReflectionFormulae.h
 * @brief MODEL.md's reflection models in double precision, from vectors and angles.
 *
 * They share nothing with the shader, which has only cosines.
 */
#ifndef ReflectionFormulae_h
#define ReflectionFormulae_h

#include "ReflectionGeometry.h"

namespace formula
{
constexpr double DegreesPerRadian = 57.295779513082321;

/// Angle between two directions, in radians; exact to the last digits of small angles too.
double Angle(const Vector& a, const Vector& b);

/// Square of the slope of the half vector against the normal.
double SquaredSlope(const ReflectionDirections& d);

double Lambert(const ReflectionDirections& d);
double OrenNayar(const ReflectionDirections& d, double roughness);

double Phong(const ReflectionDirections& d, double power);
double BlinnPhong(const ReflectionDirections& d, double power);
double Ward(const ReflectionDirections& d, double roughness);
double WardAnisotropic(const ReflectionDirections& d, double along, double across);

/// Without Fresnel's term.
double CookTorranceBeckmann(const ReflectionDirections& d, double slope);
double CookTorranceGaussian(const ReflectionDirections& d, double slope, double constant);

/// From Snell's law and Fresnel's equations of the two polarizations; the angle in radians.
double Fresnel(double angle, double n);
}

#endif
