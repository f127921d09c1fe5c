// c = C ka sum(Ia) + sum over lights of att spot V (C kd Id F_d + ks Is F_s), clamped to [0, 1].

uniform vec3 scene_ambient;            // sum of the lights' ambient colours times the material's factor
uniform mat3 scene_gradientToWorld;    // covariant: the inverse transpose of voxels to world, any scale

// Against the gradient, from dense to thin. Division by the largest component first keeps the length's
// squares in range. 0 where there is no gradient.
vec3 normalOf(vec3 gradient)
{
  vec3 world = scene_gradientToWorld * gradient;
  float largest = max(abs(world.x), max(abs(world.y), abs(world.z)));
  return largest > 0.0 ? -normalize(world / largest) : vec3(0.0);
}

vec3 shadedColor(vec3 position, float scalar, vec3 view)
{
  LightedPoint point = LightedPoint(position, normalOf(gradientAt(position)), view);
  Reflection sum = Reflection(vec3(0.0), vec3(0.0));
  if (point.normal != vec3(0.0))
  {
#if DIRECTIONAL_LIGHTS > 0
    addDirectionalLights(point, sum);
#endif
#if POINT_LIGHTS > 0
    addPointLights(point, sum);
#endif
#if SPOT_LIGHTS > 0
    addSpotLights(point, sum);
#endif
  }
  return clamp(colorOf(scalar) * (scene_ambient + sum.diffuse) + sum.specular, 0.0, 1.0);
}
