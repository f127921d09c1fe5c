vec3 diffuseLight(ShadedPoint point, int light, ReflectionCosines cosines)
{
  return vec3(0.0);
}
