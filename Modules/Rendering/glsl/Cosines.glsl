// What a reflection model knows of a sample: cosines between its normal N, the direction to the
// light L and the direction to the eye V.

uniform vec4 scene_reflection; // parameters of the reflection model

struct ReflectionCosines
{
  float nDotL;
  float nDotV;
  float lDotV;
};

ReflectionCosines cosinesAt(ShadedPoint point, vec3 toLight)
{
  float nDotL = dot(point.normal, toLight);
  float side = litSide(nDotL);
  return ReflectionCosines(side * nDotL, side * dot(point.normal, point.view), dot(toLight, point.view));
}
