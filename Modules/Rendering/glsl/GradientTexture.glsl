// Gradients estimated at the voxels beforehand. All estimators take values whole voxels away, so
// that interpolating their gradients is the same as estimating from interpolated values.

uniform sampler3D scene_gradients;
uniform float scene_gradientScale; // to differences of scene_scalars per voxel

vec3 gradientAt(vec3 position)
{
  return scene_gradientScale * texture(scene_gradients, position).rgb;
}
