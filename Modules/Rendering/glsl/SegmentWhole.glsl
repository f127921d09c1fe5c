// What is seen of a step that is one sample.

struct SeenSegment
{
  vec3 position;
  vec3 color;
  float weight;
};

SeenSegment seenSegment(vec4 accumulated, SegmentMatter matter, vec3 position, vec3 segment)
{
  return SeenSegment(position, segmentColor(matter), compositingWeight(accumulated, matter.depth));
}
