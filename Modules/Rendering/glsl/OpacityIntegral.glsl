// Extinction of a scalar, and the integral of extinction over scalars up to it, from a table that
// is even in the scalar. Beyond its ends the extinction is constant.

uniform sampler1D scene_extinction;
uniform vec2 scene_tableCoordinate; // scale and offset from texture value to table coordinate
uniform vec2 scene_tableEnds;       // coordinates of the first and of the last entry

struct RayEnd
{
  float coordinate;
  float extinction;
  float integral; // over table coordinates
};

RayEnd rayEndOf(float coordinate)
{
  vec2 entry = texture(scene_extinction, coordinate).rg;
  float beyond = coordinate - clamp(coordinate, scene_tableEnds.x, scene_tableEnds.y);
  return RayEnd(coordinate, entry.r, entry.g + entry.r * beyond);
}

RayEnd rayEndAt(vec3 position)
{
  return rayEndOf(
    texture(scene_scalars, position).r * scene_tableCoordinate.x + scene_tableCoordinate.y);
}

RayEnd rayEndAfterLeap(RayEnd before, int leap, vec3 position)
{
  RayEnd after = rayEndAt(position);
  return leap > 0 ? after : before;
}
