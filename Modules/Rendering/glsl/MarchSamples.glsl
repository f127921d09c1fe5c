// Composites sample after sample, for colours that cost no more than looking for the next matter
// would. Between leaps it marches to the far side of the brick.

vec4 march(ViewRay ray, int first, int last, vec4 accumulated)
{
  vec3 segment = ray.direction * scene_sampleDistance;
  int index = first;
  while (index < last && accumulated.a < scene_opaqueEnough)
  {
    int stop = index;
    bool empty = true;
    while (empty && index < last)
    {
      stop = index + stepsBeforeFarSide(stepMiddle(ray, index), segment, empty);
      index = empty ? stop : index;
    }
    stop = min(stop, last);
    RayEnd rayEnd = rayEndAt(ray.entry + float(index) * segment);
    for (; index < stop && accumulated.a < scene_opaqueEnough; ++index)
    {
      float stepLength = stepLengthOf(ray, index);
      vec3 position = stepMiddle(ray, index);
      countSample();
      SegmentMatter matter;
      float depth = segmentDepth(rayEnd, position, ray.direction, stepLength, matter);
      vec3 color = segmentColor(matter);
      accumulated += compositingWeight(accumulated, depth) *
        vec4(shadedColor(position, color, ray.view), CompositedAlpha);
    }
  }
  return accumulated;
}
