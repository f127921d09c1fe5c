// Ward's isotropic lobe (Ward 1992; thesis eq. 12), a Gaussian of the slope tan g of the half
// vector H. parameters: x the roughness, at least 0.001.

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
  float sum = c.nDotL + c.nDotV;
  float square = max(sum * sum / max(2.0f + 2.0f * c.lDotV, 1e-12f), 1e-8f);
  float slope = max(1.0f - square, 0.0f) / square;
  float variance = parameters.x * parameters.x;
  return sqrt(c.nDotL / max(c.nDotV, 1e-6f)) * exp(-slope / variance) / (12.566371f * variance);
}
