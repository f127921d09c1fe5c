// Semi-transparent occluders dim the light by their transmittance. Beyond an optical depth of 8 what is
// left is under a tenth of a grey level of 255.

float softVisibility(vec3 position, ShadowSegment towardsLight)
{
  return exp(-opticalDepth(
    position, towardsLight.direction, towardsLight.begin, towardsLight.end, 8.0));
}
