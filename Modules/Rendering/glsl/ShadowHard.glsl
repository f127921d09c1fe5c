// A light whose shadow lets all of it through or none.

void addHardLight(ShadedPoint point, int light, Illumination illumination, inout Reflection sum)
{
  Reflection reflected = reflectLight(point, light, illumination);
  illumination.segment.end = shadowReach(reflected, illumination.segment.end);
  addReflection(sum, reflected, hardVisibility(point.position, light, illumination.segment));
}
