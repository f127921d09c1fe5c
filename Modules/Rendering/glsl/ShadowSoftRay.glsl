// Semi-transparent occluders dim the light by their transmittance.

float softVisibility(vec3 position, ShadowSegment towardsLight)
{
  return exp(-opticalDepth(position, towardsLight.direction, towardsLight.begin, towardsLight.end,
    towardsLight.enough));
}

void addSoftLight(ShadedPoint point, int light, Illumination illumination, inout Reflection sum)
{
  Reflection reflected = reflectLight(point, light, illumination);
  illumination.segment.end = shadowReach(reflected, illumination.segment.end);
  illumination.segment.enough = darkeningDepth(reflected);
  addReflection(sum, reflected, softVisibility(point.position, illumination.segment));
}
