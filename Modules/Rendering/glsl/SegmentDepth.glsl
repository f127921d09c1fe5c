// Optical depth of one step of a ray, its sample in the middle of what is shown of the step. The
// position is moved there; the scalar is returned for the caller's colour.

float segmentDepth(inout vec3 position, vec3 direction, float stepLength, out float scalar)
{
  vec3 segment = direction * stepLength;
  float shown = shownByCropping(position, segment);
  shown *= shownByMask(position, segment * shown);
  scalar = texture(scene_scalars, position).r;
  return extinctionOf(scalar) * gradientOpacityAt(position) * (stepLength * shown);
}
