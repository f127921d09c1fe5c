// Where a ray is inside the visible box (Kay and Kajiya 1986), which holds its own faces.

const vec3 NoDirection = vec3(1e-20);

// A component that is 0 counts as one too small to matter.
vec3 reciprocalDirection(vec3 direction)
{
  return 1.0 / mix(direction, NoDirection, lessThan(abs(direction), NoDirection));
}

vec2 insideBox(vec3 position, vec3 direction)
{
  vec3 reciprocal = reciprocalDirection(direction);
  vec3 low = (scene_boxLow - position) * reciprocal;
  vec3 high = (scene_boxHigh - position) * reciprocal;
  vec3 entry = min(low, high);
  vec3 exit = max(low, high);
  // Along an axis that the ray does not move on it is inside for good, on the very faces too, or
  // never.
  vec3 within = step(scene_boxLow, position) * step(position, scene_boxHigh);
  vec3 forGood = (2.0 * within - 1.0) * 1e30;
  bvec3 parallel = lessThan(abs(direction), NoDirection);
  entry = mix(entry, -forGood, parallel);
  exit = mix(exit, forGood, parallel);
  return vec2(max(entry.x, max(entry.y, entry.z)), min(exit.x, min(exit.y, exit.z)));
}
