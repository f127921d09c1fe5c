uniform vec3 scene_lightSpecular[LIGHTS]; // specular colour, intensity and the material's factor
uniform vec3 scene_indexOfRefraction;

vec3 specularLight(ShadedPoint point, int light, ReflectionCosines cosines)
{
  float vDotH = sqrt(max(0.5 + 0.5 * cosines.lDotV, 0.0));
  vec3 reflectance = vec3(fresnelReflectance(vDotH, scene_indexOfRefraction.r),
    fresnelReflectance(vDotH, scene_indexOfRefraction.g), fresnelReflectance(vDotH, scene_indexOfRefraction.b));
  return scene_lightSpecular[light] * reflectance *
    fadedSpecular(point, specularReflection(cosines, scene_reflection));
}
