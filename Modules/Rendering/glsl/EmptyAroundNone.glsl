bool emptyAround(vec3 position, vec3 reach)
{
  return false;
}
