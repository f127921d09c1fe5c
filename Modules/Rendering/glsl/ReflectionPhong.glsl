// Phong's reflection (Phong 1975; thesis eq. 3 to 7), from the cosines between normal N, direction to
// the light L and direction to the eye V. R = 2 (N.L) N - L is L mirrored at N.

float diffuseReflection(float nDotL)
{
  return max(nDotL, 0.0f);
}

float specularReflection(float nDotL, float nDotV, float lDotV, float power)
{
  float rDotV = min(2.0f * nDotL * nDotV - lDotV, 1.0f);
  if (nDotL <= 0.0f || rDotV <= 0.0f)
  {
    return 0.0f;
  }
  return power > 0.0f ? pow(rDotV, power) : 1.0f;
}
