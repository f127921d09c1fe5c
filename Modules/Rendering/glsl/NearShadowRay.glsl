// Optical depth of the part towards a light that is marched: many steps, or the whole ray of a
// light that is not kept.

float nearShadowDepth(vec3 position, ShadowSegment towardsLight, float marched)
{
  return marched > 0.0 ? opticalDepth(position, towardsLight.direction, towardsLight.begin,
    min(towardsLight.begin + marched, towardsLight.end), towardsLight.enough) : 0.0;
}
