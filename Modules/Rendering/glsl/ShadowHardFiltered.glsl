// Opaque occluders by a shadow map, whose texels are dark from the first hit on, where the
// accumulated opacity exceeds the light's threshold: percentage-closer filtering (Reeves, Salesin
// and Cook 1987) averages what the four rays around a point say.

float hardVisibility(vec3 position, int light, ShadowSegment towardsLight)
{
  if (scene_lightMap[light].x < 0.0)
  {
    float depth = nearShadowDepth(position, towardsLight, scene_lightMap[light].y);
    return depth > towardsLight.enough ? 0.0 : 1.0;
  }
  return 1.0 - keptDarkness(position, light, towardsLight.begin);
}
