// The steps that a shadow ray is cut into, of the shadow sample distance each, the last one
// shorter.

uniform float scene_shadowSampleDistance;

// A step's middle, and its length in w.
vec4 shadowStep(vec3 entry, vec3 direction, int step, float rayLength)
{
  float begin = float(step) * scene_shadowSampleDistance;
  float stepLength = clamp(rayLength - begin, 0.0, scene_shadowSampleDistance);
  return vec4(entry + direction * (begin + 0.5 * stepLength), stepLength);
}

float shadowStepDepth(inout RayEnd rayEnd, vec3 direction, vec4 step)
{
  countShadowStep(step.w);
  vec3 middle = step.xyz;
  SegmentMatter matter;
  return segmentDepth(rayEnd, middle, direction, step.w, matter);
}
