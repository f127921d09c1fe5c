// Point lights.

void addPointLights(LightedPoint point, inout Reflection sum)
{
#if POINT_UNSHADOWED > 0
  for (int light = POINT_FIRST; light < POINT_FIRST + POINT_UNSHADOWED; ++light)
  {
    addReflection(sum, reflectLight(point, light, pointLight(point, light)), 1.0);
  }
#endif
#if POINT_SOFT > 0
  for (int light = POINT_SOFT_FIRST; light < POINT_SOFT_FIRST + POINT_SOFT; ++light)
  {
    Illumination illumination = pointLight(point, light);
    Reflection reflected = reflectLight(point, light, illumination);
    illumination.segment.end = shadowReach(reflected, illumination.segment.end);
    addReflection(sum, reflected, softVisibility(point.position, illumination.segment));
  }
#endif
#if POINT_HARD > 0
  for (int light = POINT_HARD_FIRST; light < POINT_HARD_FIRST + POINT_HARD; ++light)
  {
    Illumination illumination = pointLight(point, light);
    Reflection reflected = reflectLight(point, light, illumination);
    illumination.segment.end = shadowReach(reflected, illumination.segment.end);
    addReflection(sum, reflected, hardVisibility(point.position, illumination.segment));
  }
#endif
}
