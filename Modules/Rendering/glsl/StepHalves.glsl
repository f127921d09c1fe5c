// A step that much is seen of is lit in two halves: over half a voxel of measured data the normal
// turns far enough to be seen.

struct LitStep
{
  RayEnd begin;
  vec3 middle;
  float length;
};

const float HalvedWeight = 0.1;

// Makes of a step that is to be halved its first half, of a step whose first half was lit its
// second.
void takeHalf(vec4 accumulated, vec3 direction, inout bool halfLeft, inout LitStep lit,
  inout vec3 position, inout SegmentMatter matter, inout float depth)
{
  bool second = halfLeft;
  halfLeft = !second && compositingWeight(accumulated, depth) > HalvedWeight;
  if (halfLeft || second)
  {
    // The middle of the second half lies a half's length behind that of the first.
    lit.length *= second ? 1.0 : 0.5;
    lit.middle += direction * (second ? lit.length : -0.5 * lit.length);
    position = lit.middle;
    depth = segmentDepth(lit.begin, position, direction, lit.length, matter);
  }
}
