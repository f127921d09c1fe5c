uniform vec3 scene_lightDiffuse[LIGHTS]; // diffuse colour, intensity and the material's factor

vec3 diffuseLight(int light, float nDotL)
{
  return scene_lightDiffuse[light] * diffuseReflection(nDotL);
}
