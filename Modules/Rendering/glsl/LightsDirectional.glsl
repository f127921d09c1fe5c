// Light that comes from one direction everywhere; headlights are of this kind.

Illumination directionalLight(ShadedPoint point, int light)
{
  return Illumination(scene_lightDirection[light], 1.0,
    ShadowSegment(scene_lightPosition[light], scene_lightShadow[light].x, 1e30, scene_lightShadow[light].y));
}

void addDirectionalLights(ShadedPoint point, inout Reflection sum)
{
#if DIRECTIONAL_UNSHADOWED > 0
  for (int light = DIRECTIONAL_FIRST; light < DIRECTIONAL_FIRST + DIRECTIONAL_UNSHADOWED; ++light)
  {
    addUnshadowedLight(point, light, directionalLight(point, light), sum);
  }
#endif
#if DIRECTIONAL_SOFT > 0
  for (int light = DIRECTIONAL_SOFT_FIRST; light < DIRECTIONAL_SOFT_FIRST + DIRECTIONAL_SOFT; ++light)
  {
    addSoftLight(point, light, directionalLight(point, light), sum);
  }
#endif
#if DIRECTIONAL_HARD > 0
  for (int light = DIRECTIONAL_HARD_FIRST; light < DIRECTIONAL_HARD_FIRST + DIRECTIONAL_HARD; ++light)
  {
    addHardLight(point, light, directionalLight(point, light), sum);
  }
#endif
}
