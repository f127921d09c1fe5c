// A surface of mirroring facets (Cook and Torrance 1982; thesis eq. 13 to 17), but for Fresnel's
// term, which is D G / (pi N.V). G / N.V is taken as one minimum, which has no pole at grazing
// views. parameters: x the root mean square slope m, at least 0.001; y the constant of the Gaussian
// distribution, or below 0 for Beckmann's.

float diffuseReflection(ReflectionCosines c, vec4 parameters)
{
  return max(c.nDotL, 0.0f);
}

float beckmannDistribution(float square, float m)
{
  return exp(-max(1.0f - square, 0.0f) / (square * m * m)) / (m * m * square * square);
}

float gaussianDistribution(float square, float m, float constant)
{
  float angle = acos(min(sqrt(square), 1.0f));
  return constant * exp(-angle * angle / (m * m));
}

float specularReflection(ReflectionCosines c, vec4 parameters)
{
  if (c.nDotL <= 0.0f || c.nDotV <= 0.0f)
  {
    return 0.0f;
  }
  float twice = sqrt(max(2.0f + 2.0f * c.lDotV, 1e-12f)); // |L+V| = 2 V.H
  float nDotH = min((c.nDotL + c.nDotV) / twice, 1.0f);
  float vDotH = 0.5f * twice;
  float square = max(nDotH * nDotH, 1e-8f); // (N.H)^2
  float distribution = parameters.y < 0.0f ? beckmannDistribution(square, parameters.x)
                                           : gaussianDistribution(square, parameters.x, parameters.y);
  float nDotV = max(c.nDotV, 1e-6f);
  float facing = 2.0f * nDotH / vDotH;
  float geometry = min(1.0f / nDotV, min(facing, facing * c.nDotL / nDotV));
  return distribution * geometry * 0.31830989f;
}
