// Shading is dear: each round marches and leaps on to the next step that has any matter before it
// shades that. The second half of a halved step is a round of its own.

vec4 march(ViewRay ray, int first, int last, vec4 accumulated)
{
  vec3 segment = ray.direction * scene_sampleDistance;
  int index = first;
  index += emptySteps(stepMiddle(ray, index), segment);
  RayEnd rayEnd = rayEndAt(ray.entry + float(index) * segment);
  LitStep lit;
  bool halfLeft = false;
  while ((index < last || halfLeft) && accumulated.a < scene_opaqueEnough)
  {
    vec3 position;
    SegmentMatter matter;
    float depth = 0.0;
    while (index < last && depth <= 0.0 && !halfLeft)
    {
      lit = LitStep(rayEnd, stepMiddle(ray, index), stepLengthOf(ray, index));
      position = lit.middle;
      countSample();
      depth = segmentDepth(rayEnd, position, ray.direction, lit.length, matter);
      ++index;
      int leap = emptySteps(stepMiddle(ray, index), segment);
      index += leap;
      rayEnd = rayEndAfterLeap(rayEnd, leap, ray.entry + float(index) * segment);
    }
    takeHalf(accumulated, ray.direction, halfLeft, lit, position, matter, depth);
    if (depth > 0.0)
    {
      countShadedSample();
      SeenSegment seen = seenSegment(accumulated, matter, position, ray.direction * lit.length);
      vec3 color = shadedColor(seen.position, seen.color, ray.view);
      accumulated += seen.weight * vec4(color, CompositedAlpha);
    }
  }
  return accumulated;
}
