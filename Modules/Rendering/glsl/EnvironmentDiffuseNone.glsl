vec3 environmentDiffuse(ShadedPoint point)
{
  return vec3(0.0);
}
