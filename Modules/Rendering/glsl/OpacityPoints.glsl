// Extinction of a scalar, and its colour, by linear interpolation between the points of the
// transfer functions themselves, for functions too fine or too steep for an even table. Row 0 holds
// the points' scalars relative to scene_pointOffset, ascending; row 1 colour and opacity.

uniform sampler2D scene_points;
uniform int scene_pointSearchSteps;      // halvings that leave one interval
uniform float scene_pointOffset;
uniform float scene_reciprocalUnitDistance;

vec4 pointsAt(float scalar)
{
  float relative = scalar - scene_pointOffset;
  int low = 0;
  int high = textureSize(scene_points, 0).x - 1;
  for (int halving = 0; halving < scene_pointSearchSteps; ++halving)
  {
    int middle = (low + high) / 2;
    bool below = texelFetch(scene_points, ivec2(middle, 0), 0).r <= relative;
    low = below && middle > low ? middle : low;
    high = below || middle == high ? high : middle;
  }
  float from = texelFetch(scene_points, ivec2(low, 0), 0).r;
  float to = texelFetch(scene_points, ivec2(high, 0), 0).r;
  float fraction = to > from ? clamp((relative - from) / (to - from), 0.0, 1.0) : 0.0;
  return mix(texelFetch(scene_points, ivec2(low, 1), 0), texelFetch(scene_points, ivec2(high, 1), 0), fraction);
}

float extinctionOf(float scalar)
{
  return extinctionOfOpacity(pointsAt(scalar).a) * scene_reciprocalUnitDistance;
}
