// Light from a position, which may lie inside the volume: its shadow ray ends there.

Illumination pointLight(ShadedPoint point, int light)
{
  vec3 toLight = scene_lightPosition[light] - point.position;
  vec3 toLightWorld = scene_textureToWorld * toLight;
  float distance = length(toLightWorld);
  float reach = length(scene_textureToOwn * toLight);
  if (distance <= 0.0)
  {
    return Illumination(vec3(0.0), 0.0, ShadowSegment(vec3(0.0), 0.0, 0.0, 0.0));
  }
  return Illumination(toLightWorld / distance, attenuationOf(light, distance),
    ShadowSegment(toLight / reach, scene_lightShadow[light].x, reach, scene_lightShadow[light].y));
}
