uniform vec3 scene_lightSpecular[LIGHTS]; // specular colour, intensity and the material's factor

vec3 specularLight(ShadedPoint point, int light, ReflectionCosines cosines)
{
  return scene_lightSpecular[light] * fadedSpecular(point, specularReflection(cosines, scene_reflection));
}
