// Optical depth of one step of a ray, its sample in the middle of what is shown of the step. The
// position is moved there; the scalar is kept for the colour, the depth for the weight.

struct RayEnd
{
  float unused; // a sample needs nothing of the one before it
};

struct SegmentMatter
{
  float scalar;
  float depth;
};

const RayEnd NoEnd = RayEnd(0.0);
const SegmentMatter NoMatter = SegmentMatter(0.0, 0.0);

RayEnd rayEndAt(vec3 position)
{
  return RayEnd(0.0);
}

int leapOver(int steps, inout RayEnd end)
{
  return steps;
}

float segmentDepth(
  inout RayEnd end, inout vec3 position, vec3 direction, float stepLength, out SegmentMatter matter)
{
  vec3 segment = direction * stepLength;
  float shown = shownByCropping(position, segment);
  shown *= shownByMask(position, segment * shown);
  matter.scalar = texture(scene_scalars, position).r;
  matter.depth =
    extinctionOf(matter.scalar) * gradientOpacityAt(position) * (stepLength * shown);
  return matter.depth;
}
