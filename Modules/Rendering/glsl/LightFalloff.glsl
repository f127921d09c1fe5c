// How a positional light weakens with distance and towards the border of its cone.

// min(1 / (c1 + c2 d + c3 d^2), 1); a denominator that is not positive counts as 1 (thesis eq. 8).
float distanceAttenuation(float c1, float c2, float c3, float distance)
{
  float denominator = c1 + distance * (c2 + distance * c3);
  return denominator > 1.0f ? 1.0f / denominator : 1.0f;
}

// (cos t)^exponent within the cone, 0 outside; cosines of the angle from the axis and of the half
// angle.
float coneFalloff(float cosine, float coneCosine, float exponent)
{
  if (cosine < coneCosine || cosine <= 0.0f)
  {
    return 0.0f;
  }
  return exponent > 0.0f ? pow(min(cosine, 1.0f), exponent) : 1.0f;
}
