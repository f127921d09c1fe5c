float shownByMask(inout vec3 position, vec3 segment)
{
  return 1.0;
}
