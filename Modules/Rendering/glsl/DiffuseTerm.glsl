uniform vec3 scene_lightDiffuse[LIGHTS]; // diffuse colour, intensity and the material's factor

vec3 diffuseLight(ShadedPoint point, int light, ReflectionCosines cosines)
{
  return scene_lightDiffuse[light] * fadedDiffuse(point, diffuseReflection(cosines, scene_reflection));
}
