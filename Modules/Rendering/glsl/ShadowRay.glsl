// Optical depth from a sample towards a light, between two distances, as far as matter is visible.
// The ray may stop once it is enough. Four steps are taken at a time: drivers that bound the
// iterations of a fragment count a quarter of them.

// No ray has more: steps are made longer before.
const float MostShadowSteps = 1e6;

float opticalDepth(vec3 position, vec3 direction, float begin, float end, float enough)
{
  vec2 visible = keptByPlanes(insideBox(position, direction), position, direction);
  float rayLength = min(end, visible.y) - begin;
  vec3 entry = position + direction * begin;
  int last = int(clamp(ceil(rayLength / scene_shadowSampleDistance), 0.0, MostShadowSteps));
  vec3 segment = direction * scene_shadowSampleDistance;
  float depth = 0.0;
  RayEnd rayEnd = rayEndAt(entry);
  int step = 0;
  while (true)
  {
    depth += shadowStepDepth(rayEnd, direction, shadowStep(entry, direction, step, rayLength));
    depth += shadowStepDepth(rayEnd, direction, shadowStep(entry, direction, step + 1, rayLength));
    depth += shadowStepDepth(rayEnd, direction, shadowStep(entry, direction, step + 2, rayLength));
    depth += shadowStepDepth(rayEnd, direction, shadowStep(entry, direction, step + 3, rayLength));
    step += 4;
    step += leapOver(emptySteps(shadowStep(entry, direction, step, rayLength).xyz, segment), rayEnd);
    if (depth > enough)
    {
      // What it is, but not the other exit's value (README, Loops).
      depth = max(depth, enough);
      break;
    }
    if (step >= last)
    {
      break;
    }
  }
  return depth;
}
