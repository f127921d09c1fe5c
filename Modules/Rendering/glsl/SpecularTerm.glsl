uniform vec3 scene_lightSpecular[LIGHTS]; // specular colour, intensity and the material's factor
uniform float scene_specularPower;

vec3 specularLight(int light, float nDotL, float nDotV, float lDotV)
{
  return scene_lightSpecular[light] * specularReflection(nDotL, nDotV, lDotV, scene_specularPower);
}
