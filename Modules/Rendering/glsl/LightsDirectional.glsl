// Light that comes from one direction everywhere; headlights are of this kind.

Illumination directionalLight(ShadedPoint point, int light)
{
  return Illumination(scene_lightDirection[light], 1.0,
    ShadowSegment(scene_lightPosition[light], scene_lightShadow[light].x, 1e30, scene_lightShadow[light].y));
}

void addDirectionalLights(ShadedPoint point, inout Reflection sum)
{
  int light;
#if DIRECTIONAL_UNSHADOWED > 0
  light = DIRECTIONAL_FIRST;
  do
  {
    addUnshadowedLight(point, light, directionalLight(point, light), sum);
  } while (++light < DIRECTIONAL_FIRST + DIRECTIONAL_UNSHADOWED);
#endif
#if DIRECTIONAL_SOFT > 0
  light = DIRECTIONAL_SOFT_FIRST;
  do
  {
    addSoftLight(point, light, directionalLight(point, light), sum);
  } while (++light < DIRECTIONAL_SOFT_FIRST + DIRECTIONAL_SOFT);
#endif
#if DIRECTIONAL_HARD > 0
  light = DIRECTIONAL_HARD_FIRST;
  do
  {
    addHardLight(point, light, directionalLight(point, light), sum);
  } while (++light < DIRECTIONAL_HARD_FIRST + DIRECTIONAL_HARD);
#endif
}
