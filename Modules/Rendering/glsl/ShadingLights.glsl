// c = C ka sum(Ia) + sum over lights of att spot V (C kd Id F_d + ks Is F_s), clamped to [0, 1].

uniform vec3 scene_ambient; // sum of the lights' ambient colours times the material's factor

vec3 shadedColor(vec3 position, vec3 color, vec3 view)
{
  ShadedPoint point = shadedPoint(position, gradientAt(position), view);
  Reflection sum = Reflection(vec3(0.0), vec3(0.0));
  if (reflects(point))
  {
#if SHADOWED_LIGHTS > 0
    lookUpShadows(point.position);
#endif
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
  return clamp(color * (scene_ambient + sum.diffuse) + sum.specular, 0.0, 1.0);
}
