// Mean colour of a step, weighted by the extinction over all scalars between its ends.

uniform sampler1D scene_color;
uniform sampler1D scene_colorIntegral;  // of extinction times colour
uniform float scene_colorIntegralLeast; // integrals of the extinction below it are too rough for a colour

vec3 colorIntegralAt(RayEnd end)
{
  float within = clamp(end.coordinate, scene_tableEnds.x, scene_tableEnds.y);
  float beyond = end.extinction * (end.coordinate - within);
  return texture(scene_colorIntegral, end.coordinate).rgb +
    beyond * texture(scene_color, end.coordinate).rgb;
}

vec3 segmentColor(SegmentMatter matter)
{
  float integral = matter.to.integral - matter.from.integral;
  bool steep;
  meanExtinction(matter, steep);
  if (steep && abs(integral) > scene_colorIntegralLeast)
  {
    return clamp((colorIntegralAt(matter.to) - colorIntegralAt(matter.from)) / integral, 0.0, 1.0);
  }
  return texture(scene_color, 0.5 * (matter.from.coordinate + matter.to.coordinate)).rgb;
}
