float attenuationOf(int light, float distance)
{
  return 1.0;
}
