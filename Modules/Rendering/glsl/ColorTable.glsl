// Colour of a scalar from a table that is even in the scalar.

uniform sampler1D scene_color;

vec3 colorOf(float scalar)
{
  return texture(scene_color, scalar * scene_tableCoordinate.x + scene_tableCoordinate.y).rgb;
}
