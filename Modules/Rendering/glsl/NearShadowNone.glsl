// Nothing towards a light is marched: what is kept tells all.

float nearShadowDepth(vec3 position, ShadowSegment towardsLight, float marched)
{
  return 0.0;
}
