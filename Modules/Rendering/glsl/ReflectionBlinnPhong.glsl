// Blinn's variant of Phong's reflection (Blinn 1977), by the half vector H = (L+V) / |L+V|.
// parameters: x the power n, 0 or more.

float diffuseReflection(ReflectionCosines c, vec4 parameters)
{
  return max(c.nDotL, 0.0f);
}

float specularReflection(ReflectionCosines c, vec4 parameters)
{
  if (c.nDotL <= 0.0f || c.nDotV <= 0.0f)
  {
    return 0.0f;
  }
  float nDotH = min((c.nDotL + c.nDotV) / sqrt(max(2.0f + 2.0f * c.lDotV, 1e-12f)), 1.0f);
  return parameters.x > 0.0f ? pow(nDotH, parameters.x) : 1.0f;
}
