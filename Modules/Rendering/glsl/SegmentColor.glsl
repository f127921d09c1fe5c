// Colour of a step's sample.

vec3 segmentColor(SegmentMatter matter)
{
  return colorOf(matter.scalar);
}
