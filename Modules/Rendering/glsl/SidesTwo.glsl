// Two-sided lighting: the normal is flipped to the lit side.
float litSide(float nDotL)
{
  return nDotL < 0.0 ? -1.0 : 1.0;
}
