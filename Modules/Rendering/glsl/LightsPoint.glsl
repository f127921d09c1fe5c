// Point lights.

void addPointLights(ShadedPoint point, inout Reflection sum)
{
#if POINT_UNSHADOWED > 0
  for (int light = POINT_FIRST; light < POINT_FIRST + POINT_UNSHADOWED; ++light)
  {
    addUnshadowedLight(point, light, pointLight(point, light), sum);
  }
#endif
#if POINT_SOFT > 0
  for (int light = POINT_SOFT_FIRST; light < POINT_SOFT_FIRST + POINT_SOFT; ++light)
  {
    addSoftLight(point, light, pointLight(point, light), sum);
  }
#endif
#if POINT_HARD > 0
  for (int light = POINT_HARD_FIRST; light < POINT_HARD_FIRST + POINT_HARD; ++light)
  {
    addHardLight(point, light, pointLight(point, light), sum);
  }
#endif
}
