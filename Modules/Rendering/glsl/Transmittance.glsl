// Opacity of matter of optical depth tau, 1 - exp(-tau) (Max 1995, eq. 5). The series keeps the
// digits that the difference would lose where tau is small.

float opacityOfDepth(float tau)
{
  if (tau < 0.0625f)
  {
    return tau * (1.0f - tau * (0.5f - tau * (0.16666667f - tau * 0.041666667f)));
  }
  return 1.0f - exp(-tau);
}

// Extinction per unit distance of matter of this opacity per unit distance, at most that of 1 -
// 2^-24.
float extinctionOfOpacity(float opacity)
{
  float bounded = max(min(opacity, 0.99999994f), 0.0f);
  if (bounded < 0.0009765625f)
  {
    return bounded * (1.0f + bounded * (0.5f + bounded * 0.33333333f));
  }
  return -log(1.0f - bounded);
}
