vec2 keptByPlanes(vec2 interval, vec3 position, vec3 direction)
{
  return interval;
}
