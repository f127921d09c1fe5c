// Sobel's operator in three dimensions (thesis eq. 23 to 25): interpolated values of the 26
// neighbours, one voxel away along each axis, weighted 1-3-1/3-6-3/1-3-1 across the axis of the
// difference. The weights of a plane sum to 22, two voxels lie between the planes. No loop: drivers
// count iterations.

// Three neighbours along x, at offsets of y and z that are not both 0.
void addRow(vec3 position, float y, float z, inout vec3 sum)
{
  vec3 middle = position + vec3(0.0, y, z) * scene_voxel;
  vec3 dx = vec3(scene_voxel.x, 0.0, 0.0);
  float before = texture(scene_scalars, middle - dx).r;
  float here = texture(scene_scalars, middle).r;
  float after = texture(scene_scalars, middle + dx).r;
  float acrossX = y * z == 0.0 ? 3.0 : 1.0;
  float acrossY = z == 0.0 ? 3.0 : 1.0;
  float acrossZ = y == 0.0 ? 3.0 : 1.0;
  sum.x += acrossX * (after - before);
  sum.y += y * (acrossY * (before + after) + (z == 0.0 ? 6.0 : 3.0) * here);
  sum.z += z * (acrossZ * (before + after) + (y == 0.0 ? 6.0 : 3.0) * here);
}

vec3 gradientAt(vec3 position)
{
  vec3 dx = vec3(scene_voxel.x, 0.0, 0.0);
  vec3 sum = vec3(
    6.0 * (texture(scene_scalars, position + dx).r - texture(scene_scalars, position - dx).r), 0.0, 0.0);
  addRow(position, -1.0, -1.0, sum);
  addRow(position, 0.0, -1.0, sum);
  addRow(position, 1.0, -1.0, sum);
  addRow(position, -1.0, 0.0, sum);
  addRow(position, 1.0, 0.0, sum);
  addRow(position, -1.0, 1.0, sum);
  addRow(position, 0.0, 1.0, sum);
  addRow(position, 1.0, 1.0, sum);
  return sum / 44.0;
}
