// Composites sample after sample, for colours that cost no more than looking for the next matter
// would.

vec4 march(ViewRay ray, int first, int last, vec4 accumulated)
{
  vec3 segment = ray.direction * scene_sampleDistance;
  int index = first + emptySteps(stepMiddle(ray, first), segment);
  if (index >= last || accumulated.a >= scene_opaqueEnough)
  {
    return accumulated;
  }
  RayEnd rayEnd = rayEndAt(ray.entry + float(index) * segment);
  while (true)
  {
    vec3 position = stepMiddle(ray, index);
    countSample();
    SegmentMatter matter;
    float depth = segmentDepth(rayEnd, position, ray.direction, stepLengthOf(ray, index), matter);
    vec3 color = shadedColor(position, segmentColor(matter), ray.view);
    accumulated += compositingWeight(accumulated, depth) * vec4(color, CompositedAlpha);
    ++index;
    index += leapOver(emptySteps(stepMiddle(ray, index), segment), rayEnd);
    if (accumulated.a >= scene_opaqueEnough)
    {
      accumulated /= accumulated.a;
      break;
    }
    if (index >= last)
    {
      break;
    }
  }
  return accumulated;
}
