// Matter that absorbs only.

vec3 shadedColor(vec3 position, float scalar, vec3 view)
{
  return vec3(0.0);
}
