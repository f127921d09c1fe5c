uniform mat3 scene_gradientToWorld;    // covariant: the inverse transpose of voxels to world, any scale

// Against the gradient, from dense to thin. Division by the largest component first keeps the
// length's squares in range. 0 where there is no gradient.
vec3 normalOf(vec3 gradient)
{
  vec3 world = scene_gradientToWorld * gradient;
  float largest = max(abs(world.x), max(abs(world.y), abs(world.z)));
  return largest > 0.0 ? -normalize(world / largest) : vec3(0.0);
}
