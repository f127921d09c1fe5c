uniform vec3 scene_lightAttenuation[LIGHTS];

float attenuationOf(int light, float distance)
{
  vec3 c = scene_lightAttenuation[light];
  return distanceAttenuation(c.x, c.y, c.z, distance);
}
