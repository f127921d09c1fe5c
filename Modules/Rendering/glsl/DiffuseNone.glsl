vec3 diffuseLight(int light, float nDotL)
{
  return vec3(0.0);
}
