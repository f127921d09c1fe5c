// Forward differences: the interpolated value one voxel ahead less that of the sample, per voxel
// (thesis eq. 22). Values are clamped at the outermost voxel centres by the texture itself.

vec3 gradientAt(vec3 position)
{
  float here = texture(scene_scalars, position).r;
  return vec3(texture(scene_scalars, position + vec3(scene_voxel.x, 0.0, 0.0)).r - here,
    texture(scene_scalars, position + vec3(0.0, scene_voxel.y, 0.0)).r - here,
    texture(scene_scalars, position + vec3(0.0, 0.0, scene_voxel.z)).r - here);
}
