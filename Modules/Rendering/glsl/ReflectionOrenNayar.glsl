// Matt surfaces of facets that are Lambert's (Oren and Nayar 1994; thesis eq. 10). With the larger
// angle a and the smaller angle b of L and V to N, and C the difference of their azimuths, cos C
// sin a tan b is (L.V - N.L N.V) / max(N.L, N.V). parameters: x is A, y is B.

float diffuseReflection(ReflectionCosines c, vec4 parameters)
{
  if (c.nDotL <= 0.0f)
  {
    return 0.0f;
  }
  float nDotV = max(c.nDotV, 0.0f);
  float across = c.lDotV - c.nDotL * c.nDotV;
  // An eye below the horizon keeps its azimuth and counts as on it. Within .2 degrees of -N
  // rounding leaves none.
  float azimuth = c.nDotV < 0.0f ? across / sqrt(max(1.0f - c.nDotV * c.nDotV, 1e-5f)) : across;
  float nearer = c.nDotL / max(c.nDotL, nDotV);
  return c.nDotL * parameters.x + parameters.y * max(azimuth, 0.0f) * nearer;
}

float specularReflection(ReflectionCosines c, vec4 parameters)
{
  return 0.0f;
}
