// What a reflection model knows of a sample: cosines between its normal N, the direction to the
// light L, the direction to the eye V, and a preferred direction P.

uniform vec3 scene_preferredDirection; // world, unit
uniform vec4 scene_reflection; // parameters of the reflection model

struct ReflectionCosines
{
  float nDotL;
  float nDotV;
  float lDotV;
  float pDotN;
  float pDotL;
  float pDotV;
};

ReflectionCosines cosinesAt(ShadedPoint point, vec3 toLight)
{
  float nDotL = dot(point.normal, toLight);
  float side = litSide(nDotL);
  return ReflectionCosines(side * nDotL, side * dot(point.normal, point.view), dot(toLight, point.view),
    side * dot(scene_preferredDirection, point.normal), dot(scene_preferredDirection, toLight),
    dot(scene_preferredDirection, point.view));
}
