uniform samplerCube scene_environmentDiffuse;
uniform float scene_diffuseFactor; // the material's

vec3 environmentDiffuse(ShadedPoint point)
{
  return scene_diffuseFactor * fadedRadiance(point, texture(scene_environmentDiffuse, point.normal).rgb);
}
