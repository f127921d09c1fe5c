// Front to back, each sample over what lies behind it.

// The part of a sample's colour that is seen through what lies before it, and what it adds to
// alpha.
float compositingWeight(vec4 accumulated, float depth)
{
  return (1.0 - accumulated.a) * opacityOfDepth(depth);
}

const float CompositedAlpha = 1.0;
