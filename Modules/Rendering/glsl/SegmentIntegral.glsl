// Optical depth of one step of a ray along which the scalar changes evenly: the mean extinction
// over all scalars between its ends, which no transfer function is too steep for (pre-integrated
// classification, Engel, Kraus and Ertl 2001, by integrals over one scalar; what a step hides of
// itself counts in its depth, not in its colour).

uniform float scene_integralRounding; // differences of the integral below it are rounding

struct SegmentMatter
{
  RayEnd from;
  RayEnd to;
  float length; // times the gradient opacity
};

const SegmentMatter NoMatter = SegmentMatter(NoEnd, NoEnd, 0.0);

// Where the integral tells no more than rounding, the extinction is taken to change evenly too.
float meanExtinction(SegmentMatter matter, out bool steep)
{
  float change = matter.to.coordinate - matter.from.coordinate;
  float even = 0.5 * (matter.from.extinction + matter.to.extinction);
  float integral = matter.to.integral - matter.from.integral;
  steep = abs(integral - even * change) > scene_integralRounding;
  return steep ? integral / change : even;
}

float segmentDepth(
  inout RayEnd end, inout vec3 position, vec3 direction, float stepLength, out SegmentMatter matter)
{
  matter.from = end;
  end = rayEndAt(position + 0.5 * stepLength * direction);
  matter.to = end;
  matter.length = matter.from.step * gradientOpacityAt(position) * stepLength;
  bool steep;
  return meanExtinction(matter, steep) * matter.length;
}
