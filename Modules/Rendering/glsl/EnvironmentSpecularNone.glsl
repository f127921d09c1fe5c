vec3 environmentSpecular(ShadedPoint point)
{
  return vec3(0.0);
}
