// Matter that emits and absorbs nothing: the integral of s C, and all that lies behind is seen.

float compositingWeight(vec4 accumulated, float depth)
{
  return depth;
}

const float CompositedAlpha = 0.0;
