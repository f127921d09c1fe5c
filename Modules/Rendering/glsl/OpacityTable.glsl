// Extinction and colour of a scalar from tables that are even in the scalar.

uniform sampler1D scene_extinction;
uniform sampler1D scene_color;
uniform vec2 scene_tableCoordinate; // scale and offset from texture value to table coordinate

float extinctionOf(float scalar)
{
  return texture(scene_extinction, scalar * scene_tableCoordinate.x + scene_tableCoordinate.y).r;
}

vec3 colorOf(float scalar)
{
  return texture(scene_color, scalar * scene_tableCoordinate.x + scene_tableCoordinate.y).rgb;
}
