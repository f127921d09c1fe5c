float gradientOpacityAt(vec3 position)
{
  return 1.0;
}
