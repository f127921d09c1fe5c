// Optical depth towards a light by a ray that is marched whole. Depths beyond the largest need not
// be told apart.

float shadowDepth(vec3 position, int light, ShadowSegment towardsLight, float largest)
{
  return opticalDepth(position, towardsLight.direction, towardsLight.begin, towardsLight.end, towardsLight.enough);
}

// Lights share nothing.
void lookUpShadows(vec3 position)
{
}
