// Leaps over empty bricks. For each of the eight octants of directions the map holds the edge of
// the largest empty cube of bricks that begins at a brick and lies ahead of it (distance maps:
// Cohen and Sheffer 1994). Rays leap by whole steps, so that the samples that are left stay where
// they are.

uniform sampler3D scene_emptyCubes; // edges in bricks, over 255; 0: a brick that may hold matter
uniform vec3 scene_bricks;          // texture coordinates to bricks
uniform vec3 scene_brickOffset;
uniform vec3 scene_lastBrick;       // one less than their count along each axis

// Steps from a position to the far side of the cube that it is in, or of its brick where there is
// none.
float stepsToFarSide(vec3 position, vec3 segment, out bool empty)
{
  vec3 extent = segment * scene_bricks;
  bvec3 ahead = greaterThanEqual(extent, vec3(0.0));
  vec3 at = position * scene_bricks + scene_brickOffset;
  vec3 brick = clamp(floor(at), vec3(0.0), scene_lastBrick);
  float octant = dot(mix(vec3(1.0, 2.0, 4.0), vec3(0.0), ahead), vec3(1.0));
  vec3 texel = vec3(brick.xy, brick.z + octant * (scene_lastBrick.z + 1.0));
  float edge = texelFetch(scene_emptyCubes, ivec3(texel), 0).r * 255.0;
  empty = edge > 0.5;
  edge = max(edge, 1.0);
  vec3 side = mix(brick + 1.0 - edge, brick + edge, ahead);
  vec3 steps = (side - at) * reciprocalDirection(extent);
  return clamp(min(steps.x, min(steps.y, steps.z)), 0.0, 1e6);
}

// How many steps have their samples before the far side, the step of this sample included.
int stepsBeforeFarSide(vec3 middle, vec3 segment, out bool empty)
{
#if WHOLE_SEGMENTS > 0
  int steps = int(stepsToFarSide(middle - 0.5 * segment, segment, empty));
  empty = empty && steps > 0;
  return max(steps, 1);
#else
  return int(stepsToFarSide(middle, segment, empty)) + 1;
#endif
}

// Steps from this one on that hold no matter.
int emptySteps(vec3 middle, vec3 segment)
{
  bool empty;
  int steps = stepsBeforeFarSide(middle, segment, empty);
  return empty ? steps : 0;
}
