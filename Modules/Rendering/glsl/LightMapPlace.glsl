// Where a sample lies on a light's map.

uniform vec4 scene_lightMapAxes[3 * LIGHTS]; // rows of the map from texture coordinates to the light's frame
uniform vec4 scene_lightMap[LIGHTS];         // which map, or -1; length that is marched, projection, extent

int mapProjection(int light)
{
  return int(scene_lightMap[light].z);
}

vec3 lightMapPlace(vec3 position, int light)
{
  vec4 point = vec4(position, 1.0);
  vec3 frame = vec3(dot(scene_lightMapAxes[3 * light], point), dot(scene_lightMapAxes[3 * light + 1], point),
    dot(scene_lightMapAxes[3 * light + 2], point));
#if POINT_LIGHTS + SPOT_LIGHTS > 0
  return mapPlaceOf(frame, mapProjection(light), scene_lightMap[light].w);
#endif
  return frame;
}
