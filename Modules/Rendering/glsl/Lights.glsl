// What the loops over the lights share. Lights are sorted by kind and, within a kind, by shadow
// state: none, soft, hard.

uniform vec3 scene_lightPosition[LIGHTS];  // directional: direction of the shadow ray; else the position
uniform vec3 scene_lightDirection[LIGHTS]; // world; directional: towards the light; spot: its axis
uniform vec2 scene_lightShadow[LIGHTS];    // where a shadow ray begins; the optical depth that is enough

struct ShadowSegment
{
  vec3 direction; // texture coordinates per length
  float begin;
  float end;
  float enough;
};

// Light that falls on a point and where it comes from, before any shadow.
struct Illumination
{
  vec3 direction; // world, towards the light; 0 where there is none
  float strength;
  ShadowSegment segment;
};

struct Reflection
{
  vec3 diffuse;  // still to be multiplied by the colour of the matter
  vec3 specular;
};

Reflection reflectLight(ShadedPoint point, int light, Illumination illumination)
{
  ReflectionCosines cosines = cosinesAt(point, illumination.direction);
  return Reflection(illumination.strength * diffuseLight(point, light, cosines),
    illumination.strength * specularLight(point, light, cosines));
}

// A light that brightens nothing needs no shadow ray.
float shadowReach(Reflection reflected, float end)
{
  return any(greaterThan(reflected.diffuse + reflected.specular, vec3(0.0))) ? end : 0.0;
}

// Beyond this optical depth what a soft shadow lets through is under a tenth of a grey level of
// 255.
float darkeningDepth(Reflection reflected)
{
  vec3 light = reflected.diffuse + reflected.specular;
  return 8.0 + log(max(1.0, max(light.r, max(light.g, light.b))));
}

void addReflection(inout Reflection sum, Reflection reflected, float visibility)
{
  sum.diffuse += visibility * reflected.diffuse;
  sum.specular += visibility * reflected.specular;
}

void addUnshadowedLight(ShadedPoint point, int light, Illumination illumination, inout Reflection sum)
{
  addReflection(sum, reflectLight(point, light, illumination), 1.0);
}
