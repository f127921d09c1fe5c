// Cropping to a box, or none at all, is in scene_boxLow and scene_boxHigh already.

float shownByCropping(inout vec3 position, vec3 segment)
{
  return 1.0;
}
