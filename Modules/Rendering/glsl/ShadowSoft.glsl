// Semi-transparent occluders dim the light by their transmittance.

const float DarkestDepth = 6.24; // transmittances beyond it are below half of 1 / 255

float softVisibility(vec3 position, int light, ShadowSegment towardsLight)
{
  return exp(-shadowDepth(position, light, towardsLight, DarkestDepth));
}

void addSoftLight(ShadedPoint point, int light, Illumination illumination, inout Reflection sum)
{
  Reflection reflected = reflectLight(point, light, illumination);
  illumination.segment.end = shadowReach(reflected, illumination.segment.end);
  illumination.segment.enough = darkeningDepth(reflected);
  addReflection(sum, reflected, softVisibility(point.position, light, illumination.segment));
}
