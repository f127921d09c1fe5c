// Colour of a step's sample.

vec3 segmentColor(SegmentMatter matter, inout vec3 position, vec3 segment)
{
  return colorOf(matter.scalar);
}
