// Optical depth towards a light from its map, which tells how dark it has grown along its rays.
// Darkness is the root of the optical depth over the largest that is told apart.
//
// Near the sample matter changes faster than texels tell: the first steps towards the light are
// marched.

// Of what lies beyond the marched steps.
float shadowDarkness(vec3 position, int light, ShadowSegment towardsLight)
{
  float before = towardsLight.begin + scene_lightMap[light].y;
  return scene_lightMap[light].x >= 0.0 && before < towardsLight.end ? keptDarkness(position, light, before) : 0.0;
}

float shadowDepth(vec3 position, int light, ShadowSegment towardsLight, float largest)
{
  float darkness = shadowDarkness(position, light, towardsLight);
  return nearShadowDepth(position, towardsLight, scene_lightMap[light].y) + largest * darkness * darkness;
}

// Lights share nothing.
void lookUpShadows(vec3 position)
{
}
