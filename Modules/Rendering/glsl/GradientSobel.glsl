// Sobel's operator in three dimensions (thesis eq. 23 to 25): interpolated values of the 26
// neighbours, one voxel away along each axis, weighted 1-3-1/3-6-3/1-3-1 across the axis of the
// difference. The weights of a plane sum to 22, two voxels lie between the planes. Values are
// subtracted before they are weighted, so that equal ones leave no rounding, which would be a
// normal. No loop: drivers count iterations.

// Three neighbours along x, at offsets of y and z.
vec3 rowAt(vec3 position, float y, float z)
{
  vec3 middle = position + vec3(0.0, y, z) * scene_voxel;
  vec3 dx = vec3(scene_voxel.x, 0.0, 0.0);
  return vec3(texture(scene_scalars, middle - dx).r, texture(scene_scalars, middle).r,
    texture(scene_scalars, middle + dx).r);
}

vec3 gradientAt(vec3 position)
{
  const vec3 Outer = vec3(1.0, 3.0, 1.0);
  const vec3 Inner = vec3(3.0, 6.0, 3.0);
  vec3 below0 = rowAt(position, -1.0, -1.0);
  vec3 below1 = rowAt(position, 0.0, -1.0);
  vec3 below2 = rowAt(position, 1.0, -1.0);
  vec3 level0 = rowAt(position, -1.0, 0.0);
  vec3 level1 = rowAt(position, 0.0, 0.0);
  vec3 level2 = rowAt(position, 1.0, 0.0);
  vec3 above0 = rowAt(position, -1.0, 1.0);
  vec3 above1 = rowAt(position, 0.0, 1.0);
  vec3 above2 = rowAt(position, 1.0, 1.0);
  vec3 belowX = vec3(below0.z - below0.x, below1.z - below1.x, below2.z - below2.x);
  vec3 levelX = vec3(level0.z - level0.x, level1.z - level1.x, level2.z - level2.x);
  vec3 aboveX = vec3(above0.z - above0.x, above1.z - above1.x, above2.z - above2.x);
  vec3 sum = vec3(dot(Outer, belowX + aboveX) + dot(Inner, levelX),
    dot(Outer, below2 - below0 + (above2 - above0)) + dot(Inner, level2 - level0),
    dot(Outer, above0 - below0 + (above2 - below2)) + dot(Inner, above1 - below1));
  return sum / 44.0;
}
