vec3 segmentColor(SegmentMatter matter)
{
  return vec3(0.0);
}
