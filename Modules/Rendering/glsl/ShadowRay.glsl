// Optical depth from a sample towards a light, between two distances, as far as matter is visible. The
// ray may stop once it is enough. Four steps are taken at a time: drivers that bound the iterations of
// a fragment count a quarter of them.

uniform float scene_shadowSampleDistance;

float shadowStepDepth(inout RayEnd rayEnd, vec3 position, vec3 direction, float begin, float end)
{
  float stepLength = clamp(end - begin, 0.0, scene_shadowSampleDistance);
  vec3 middle = position + direction * (begin + 0.5 * stepLength);
  SegmentMatter matter;
  return segmentDepth(rayEnd, middle, direction, stepLength, matter);
}

float opticalDepth(vec3 position, vec3 direction, float begin, float end, float enough)
{
  vec2 visible = keptByPlanes(insideBox(position, direction), position, direction);
  float last = min(end, visible.y);
  float depth = 0.0;
  RayEnd rayEnd = rayEndAt(position + direction * begin);
  for (float at = begin; at < last && depth <= enough; at += 4.0 * scene_shadowSampleDistance)
  {
    depth += shadowStepDepth(rayEnd, position, direction, at, last);
    depth += shadowStepDepth(rayEnd, position, direction, at + scene_shadowSampleDistance, last);
    depth += shadowStepDepth(rayEnd, position, direction, at + 2.0 * scene_shadowSampleDistance, last);
    depth += shadowStepDepth(rayEnd, position, direction, at + 3.0 * scene_shadowSampleDistance, last);
  }
  return depth;
}
