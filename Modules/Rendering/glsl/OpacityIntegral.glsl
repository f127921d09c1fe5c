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
  float step;     // 0: the next step begins elsewhere, and is empty; else 1
};

const RayEnd NoEnd = RayEnd(0.0, 0.0, 0.0, 0.0);

RayEnd rayEndOf(float coordinate)
{
  vec2 entry = texture(scene_extinction, coordinate).rg;
  float beyond = coordinate - clamp(coordinate, scene_tableEnds.x, scene_tableEnds.y);
  return RayEnd(coordinate, entry.r, entry.g + entry.r * beyond, 1.0);
}

RayEnd rayEndAt(vec3 position)
{
  return rayEndOf(
    texture(scene_scalars, position).r * scene_tableCoordinate.x + scene_tableCoordinate.y);
}

// The last of the empty steps is left to be taken: its end is looked up as that of any step is, so
// that none has to look up where it begins.
int leapOver(int steps, inout RayEnd end)
{
  end.step = steps > 0 ? 0.0 : 1.0;
  return max(steps - 1, 0);
}
