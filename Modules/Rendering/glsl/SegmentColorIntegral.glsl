// Mean colour of a step, weighted by the extinction over all scalars between its ends. The position moves to
// where, by the same weight, the step's matter is.

uniform sampler1D scene_color;
uniform sampler1D scene_colorIntegral;  // of extinction times colour, and times the table coordinate
uniform float scene_colorIntegralLeast; // integrals of the extinction below it are too rough for a colour

vec4 colorIntegralAt(RayEnd end)
{
  float within = clamp(end.coordinate, scene_tableEnds.x, scene_tableEnds.y);
  float beyond = end.extinction * (end.coordinate - within);
  return texture(scene_colorIntegral, end.coordinate) +
    beyond * vec4(texture(scene_color, end.coordinate).rgb, 0.5 * (end.coordinate + within));
}

vec3 segmentColor(SegmentMatter matter, inout vec3 position, vec3 segment)
{
  float integral = matter.to.integral - matter.from.integral;
  bool steep;
  meanExtinction(matter, steep);
  if (steep && abs(integral) > scene_colorIntegralLeast)
  {
    vec4 mean = (colorIntegralAt(matter.to) - colorIntegralAt(matter.from)) / integral;
    float part = (mean.a - matter.from.coordinate) / (matter.to.coordinate - matter.from.coordinate);
    position += (clamp(part, 0.0, 1.0) - 0.5) * segment;
    return clamp(mean.rgb, 0.0, 1.0);
  }
  return texture(scene_color, 0.5 * (matter.from.coordinate + matter.to.coordinate)).rgb;
}
