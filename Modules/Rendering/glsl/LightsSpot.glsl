// Point lights within a cone about an axis.

uniform vec2 scene_lightCone[LIGHTS]; // cosine of the half angle, exponent

Illumination spotLight(ShadedPoint point, int light)
{
  Illumination illumination = pointLight(point, light);
  illumination.strength *= coneFalloff(-dot(illumination.direction, scene_lightDirection[light]),
    scene_lightCone[light].x, scene_lightCone[light].y);
  return illumination;
}

void addSpotLights(ShadedPoint point, inout Reflection sum)
{
  int light;
#if SPOT_UNSHADOWED > 0
  light = SPOT_FIRST;
  do
  {
    addUnshadowedLight(point, light, spotLight(point, light), sum);
  } while (++light < SPOT_FIRST + SPOT_UNSHADOWED);
#endif
#if SPOT_SOFT > 0
  light = SPOT_SOFT_FIRST;
  do
  {
    addSoftLight(point, light, spotLight(point, light), sum);
  } while (++light < SPOT_SOFT_FIRST + SPOT_SOFT);
#endif
#if SPOT_HARD > 0
  light = SPOT_HARD_FIRST;
  do
  {
    addHardLight(point, light, spotLight(point, light), sum);
  } while (++light < SPOT_HARD_FIRST + SPOT_HARD);
#endif
}
