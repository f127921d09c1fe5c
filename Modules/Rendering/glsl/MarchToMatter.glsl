// Shading is dear: each round marches and leaps on to the next step that has any matter before it
// shades that. The second half of a halved step is a round of its own.

vec4 march(ViewRay ray, int first, int last, vec4 accumulated)
{
  vec3 segment = ray.direction * scene_sampleDistance;
  int index = first + emptySteps(stepMiddle(ray, first), segment);
  if (index >= last || accumulated.a >= scene_opaqueEnough)
  {
    return accumulated;
  }
  RayEnd rayEnd = rayEndAt(ray.entry + float(index) * segment);
  LitStep lit;
  vec3 position;
  SegmentMatter matter;
  bool halfLeft = false;
  while (true)
  {
    float depth = 0.0;
    while (true)
    {
      if (halfLeft)
      {
        break;
      }
      lit = LitStep(rayEnd, stepMiddle(ray, index), stepLengthOf(ray, index));
      position = lit.middle;
      countSample();
      depth = segmentDepth(rayEnd, position, ray.direction, lit.length, matter);
      ++index;
      index += leapOver(emptySteps(stepMiddle(ray, index), segment), rayEnd);
      if (depth > 0.0)
      {
        break;
      }
      if (index >= last)
      {
        // Nothing more is found; of all that is used behind the loop (README, Loops).
        index = last;
        rayEnd = NoEnd;
        lit = LitStep(NoEnd, ray.entry, 0.0);
        position = ray.entry;
        matter = NoMatter;
        depth = 0.0;
        break;
      }
    }
    takeHalf(accumulated, ray.direction, halfLeft, lit, position, matter, depth);
    if (depth > 0.0)
    {
      countShadedSample();
      SeenSegment seen = seenSegment(accumulated, matter, position, ray.direction * lit.length);
      vec3 color = shadedColor(seen.position, seen.color, ray.view);
      accumulated += seen.weight * vec4(color, CompositedAlpha);
    }
    if (accumulated.a >= scene_opaqueEnough)
    {
      accumulated /= accumulated.a;
      break;
    }
    if (index >= last && !halfLeft)
    {
      break;
    }
  }
  return accumulated;
}
