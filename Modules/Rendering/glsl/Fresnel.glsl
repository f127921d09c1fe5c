// Fresnel's reflectance of unpolarized light at a dielectric of index of refraction n (Cook and
// Torrance 1982; thesis eq. 14), from the cosine of the angle of incidence. 1 in total reflection.

float fresnelReflectance(float cosine, float n)
{
  float square = n * n - 1.0f + cosine * cosine;
  if (square < 0.0f)
  {
    return 1.0f;
  }
  float g = sqrt(square);
  float sum = max(g + cosine, 1e-12f);
  float ratio = (g - cosine) / sum;
  float along = cosine * (g - cosine) + 1.0f;
  float parallel = (cosine * sum - 1.0f) / (along > 0.0f ? along : 1e-12f);
  return min(0.5f * ratio * ratio * (1.0f + parallel * parallel), 1.0f);
}
