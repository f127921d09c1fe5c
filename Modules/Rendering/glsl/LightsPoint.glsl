// Point lights.

void addPointLights(ShadedPoint point, inout Reflection sum)
{
  int light;
#if POINT_UNSHADOWED > 0
  light = POINT_FIRST;
  do
  {
    addUnshadowedLight(point, light, pointLight(point, light), sum);
  } while (++light < POINT_FIRST + POINT_UNSHADOWED);
#endif
#if POINT_SOFT > 0
  light = POINT_SOFT_FIRST;
  do
  {
    addSoftLight(point, light, pointLight(point, light), sum);
  } while (++light < POINT_SOFT_FIRST + POINT_SOFT);
#endif
#if POINT_HARD > 0
  light = POINT_HARD_FIRST;
  do
  {
    addHardLight(point, light, pointLight(point, light), sum);
  } while (++light < POINT_HARD_FIRST + POINT_HARD);
#endif
}
