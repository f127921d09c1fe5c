// Where a ray is inside the visible box (Kay and Kajiya 1986). A component of the direction that is 0
// is replaced by one too small to matter, so that rays along an axis need no case of their own.

vec3 reciprocalDirection(vec3 direction)
{
  const vec3 tiny = vec3(1e-20);
  return 1.0 / mix(direction, tiny, lessThan(abs(direction), tiny));
}

vec2 insideBox(vec3 position, vec3 direction)
{
  vec3 reciprocal = reciprocalDirection(direction);
  vec3 low = (scene_boxLow - position) * reciprocal;
  vec3 high = (scene_boxHigh - position) * reciprocal;
  vec3 entry = min(low, high);
  vec3 exit = max(low, high);
  return vec2(max(entry.x, max(entry.y, entry.z)), min(exit.x, min(exit.y, exit.z)));
}
