// Central differences: interpolated values one voxel to each side, per voxel (thesis eq. 26).
// Values are clamped at the outermost voxel centres by the texture itself.

vec3 gradientAt(vec3 position)
{
  vec3 dx = vec3(scene_voxel.x, 0.0, 0.0);
  vec3 dy = vec3(0.0, scene_voxel.y, 0.0);
  vec3 dz = vec3(0.0, 0.0, scene_voxel.z);
  return 0.5 *
    vec3(texture(scene_scalars, position + dx).r - texture(scene_scalars, position - dx).r,
      texture(scene_scalars, position + dy).r - texture(scene_scalars, position - dy).r,
      texture(scene_scalars, position + dz).r - texture(scene_scalars, position - dz).r);
}
