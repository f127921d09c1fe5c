vec3 specularLight(int light, float nDotL, float nDotV, float lDotV)
{
  return vec3(0.0);
}
