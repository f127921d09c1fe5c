uniform samplerCube scene_environmentSpecular;
uniform float scene_specularFactor; // the material's

vec3 environmentSpecular(ShadedPoint point)
{
  vec3 mirrored = 2.0 * dot(point.normal, point.view) * point.normal - point.view;
  return scene_specularFactor * fadedSpecular(point, 1.0) * texture(scene_environmentSpecular, mirrored).rgb;
}
