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
#if SPOT_UNSHADOWED > 0
  for (int light = SPOT_FIRST; light < SPOT_FIRST + SPOT_UNSHADOWED; ++light)
  {
    addUnshadowedLight(point, light, spotLight(point, light), sum);
  }
#endif
#if SPOT_SOFT > 0
  for (int light = SPOT_SOFT_FIRST; light < SPOT_SOFT_FIRST + SPOT_SOFT; ++light)
  {
    addSoftLight(point, light, spotLight(point, light), sum);
  }
#endif
#if SPOT_HARD > 0
  for (int light = SPOT_HARD_FIRST; light < SPOT_HARD_FIRST + SPOT_HARD; ++light)
  {
    addHardLight(point, light, spotLight(point, light), sum);
  }
#endif
}
