// Nothing is known to be empty.

int stepsBeforeFarSide(vec3 middle, vec3 segment, out bool empty)
{
  empty = false;
  return 1000000;
}

int emptySteps(vec3 middle, vec3 segment)
{
  return 0;
}
