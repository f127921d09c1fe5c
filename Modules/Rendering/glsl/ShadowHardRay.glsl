// Opaque occluders: dark as soon as the accumulated opacity exceeds the light's threshold, which in
// optical depth is towardsLight.enough.

float hardVisibility(vec3 position, ShadowSegment towardsLight)
{
  float depth = opticalDepth(position, towardsLight.direction, towardsLight.begin, towardsLight.end,
    towardsLight.enough);
  return depth > towardsLight.enough ? 0.0 : 1.0;
}

void addHardLight(ShadedPoint point, int light, Illumination illumination, inout Reflection sum)
{
  Reflection reflected = reflectLight(point, light, illumination);
  illumination.segment.end = shadowReach(reflected, illumination.segment.end);
  addReflection(sum, reflected, hardVisibility(point.position, illumination.segment));
}
