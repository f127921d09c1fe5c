// Optical depth of the first steps towards a light: few enough to march them in a row, which is
// cheaper than to look for an earlier end.

float nearShadowDepth(vec3 position, ShadowSegment towardsLight, float marched)
{
  vec3 direction = towardsLight.direction;
  vec2 visible = keptByPlanes(insideBox(position, direction), position, direction);
  float end = min(min(towardsLight.begin + marched, towardsLight.end), visible.y);
  float rayLength = end - towardsLight.begin;
  vec3 entry = position + direction * towardsLight.begin;
  RayEnd rayEnd = rayEndAt(entry);
  float depth = 0.0;
  int step = 0;
  do
  {
    depth += shadowStepDepth(rayEnd, direction, shadowStep(entry, direction, step, rayLength));
  } while (++step < NEAR_SHADOW_STEPS);
  return depth;
}
