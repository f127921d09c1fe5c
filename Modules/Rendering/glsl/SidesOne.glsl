float litSide(float nDotL)
{
  return 1.0;
}
