// Extinction of a scalar from a table that is even in the scalar.

uniform sampler1D scene_extinction;
uniform vec2 scene_tableCoordinate; // scale and offset from texture value to table coordinate

float extinctionOf(float scalar)
{
  return texture(scene_extinction, scalar * scene_tableCoordinate.x + scene_tableCoordinate.y).r;
}
