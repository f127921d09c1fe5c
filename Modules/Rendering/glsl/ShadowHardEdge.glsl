// Opaque occluders: dark as soon as the accumulated opacity exceeds the light's threshold, which in
// optical depth is towardsLight.enough.

const float ThinnestShadow = 1e-6; // taken for a threshold of 0 where depths are kept

float hardVisibility(vec3 position, int light, ShadowSegment towardsLight)
{
  float largest = 2.0 * max(towardsLight.enough, ThinnestShadow);
  return shadowDepth(position, light, towardsLight, largest) > towardsLight.enough ? 0.0 : 1.0;
}
