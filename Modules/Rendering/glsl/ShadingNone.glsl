// Emission and absorption alone: the colour of the transfer function.

vec3 shadedColor(vec3 position, vec3 color, vec3 view)
{
  return color;
}
