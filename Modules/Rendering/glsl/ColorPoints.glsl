// Colour of a scalar from the points that its opacity comes from.

vec3 colorOf(float scalar)
{
  return pointsAt(scalar).rgb;
}
