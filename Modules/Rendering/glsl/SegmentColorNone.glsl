vec3 segmentColor(SegmentMatter matter, inout vec3 position, vec3 segment)
{
  return vec3(0.0);
}
