// Shading is dear: each round marches and leaps on to the next sample that has any matter before it
// shades that.

vec4 march(ViewRay ray, int first, int last, vec4 accumulated)
{
  vec3 segment = ray.direction * scene_sampleDistance;
  int index = first;
  index += emptySteps(stepMiddle(ray, index), segment);
  RayEnd rayEnd = rayEndAt(ray.entry + float(index) * segment);
  while (index < last && accumulated.a < OpaqueEnough)
  {
    vec3 position;
    float stepLength;
    SegmentMatter matter;
    float depth = 0.0;
    while (index < last && depth <= 0.0)
    {
      stepLength = stepLengthOf(ray, index);
      position = stepMiddle(ray, index);
      countSample();
      depth = segmentDepth(rayEnd, position, ray.direction, stepLength, matter);
      ++index;
      int leap = emptySteps(stepMiddle(ray, index), segment);
      index += leap;
      rayEnd = rayEndAfterLeap(rayEnd, leap, ray.entry + float(index) * segment);
    }
    if (depth > 0.0)
    {
      countShadedSample();
      SeenSegment seen =
        seenSegment(accumulated, matter, position, ray.direction * stepLength);
      vec3 color = shadedColor(seen.position, seen.color, ray.view);
      accumulated += seen.weight * vec4(color, CompositedAlpha);
    }
  }
  return accumulated;
}
