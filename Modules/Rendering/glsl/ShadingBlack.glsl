// Matter that absorbs only.

vec3 shadedColor(vec3 position, vec3 color, vec3 view)
{
  return vec3(0.0);
}
