// Emission and absorption alone: the colour of the transfer function.

vec3 shadedColor(vec3 position, float scalar, vec3 view)
{
  return colorOf(scalar);
}
