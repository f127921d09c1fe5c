// Every step is lit at one place.

struct LitStep
{
  RayEnd begin;
  vec3 middle;
  float length;
};

void takeHalf(vec4 accumulated, vec3 direction, inout bool halfLeft, inout LitStep lit,
  inout vec3 position, inout SegmentMatter matter, inout float depth)
{
}
