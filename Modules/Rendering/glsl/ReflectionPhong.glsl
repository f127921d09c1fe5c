// Phong's reflection (Phong 1975; thesis eq. 3 to 7). R = 2 (N.L) N - L is L mirrored at N.
// parameters: x the power n, 0 or more.

float diffuseReflection(ReflectionCosines c, vec4 parameters)
{
  return max(c.nDotL, 0.0f);
}

float specularReflection(ReflectionCosines c, vec4 parameters)
{
  float rDotV = min(2.0f * c.nDotL * c.nDotV - c.lDotV, 1.0f);
  if (c.nDotL <= 0.0f || rDotV <= 0.0f)
  {
    return 0.0f;
  }
  return parameters.x > 0.0f ? pow(rDotV, parameters.x) : 1.0f;
}
