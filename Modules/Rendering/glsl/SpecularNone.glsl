vec3 specularLight(ShadedPoint point, int light, ReflectionCosines cosines)
{
  return vec3(0.0);
}
