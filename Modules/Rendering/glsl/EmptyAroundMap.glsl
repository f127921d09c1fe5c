// Whether no sample within reach of a position along each axis has matter.
bool emptyAround(vec3 position, vec3 reach)
{
#if WHOLE_SEGMENTS > 0
  return false;
#else
  vec3 low = clamp(floor((position - reach) * scene_bricks + scene_brickOffset), vec3(0.0), scene_lastBrick);
  vec3 high = clamp(floor((position + reach) * scene_bricks + scene_brickOffset), vec3(0.0), scene_lastBrick);
  vec3 extent = high - low + 1.0;
  float edge = texelFetch(scene_emptyCubes, ivec3(low), 0).r * 255.0;
  return edge + 0.5 > max(extent.x, max(extent.y, extent.z));
#endif
}
