// Optical depth towards a light, computed beforehand over the visible box: up to four lights to a
// texel's components, further ones in blocks of slices behind each other. Texel centres reach from
// face to face of the box, so that nothing of another block or from outside the box is mixed in. A
// texel holds the root of the depth over the largest that is told apart: behind a smooth surface
// the depth grows with the square of the distance, so that its root is what interpolation follows
// best, and what eight bits tell best.
//
// Near the sample matter changes faster than texels tell: the first steps towards the light are
// marched, and texels hold what lies beyond as many.

uniform sampler3D scene_shadowVolume;
uniform vec3 scene_shadowVolumeScale;            // texture coordinates of the volume to those of a block
uniform vec3 scene_shadowVolumeOffset;
uniform vec4 scene_lightShadowComponent[LIGHTS]; // 1 for the light's component; all 0: nothing is kept
uniform vec2 scene_lightShadowVolume[LIGHTS];    // where its block begins; length that is marched

vec4 keptRoots; // of the first four lights, at the sample that is being lit

void lookUpShadows(vec3 position)
{
  keptRoots = texture(scene_shadowVolume, position * scene_shadowVolumeScale + scene_shadowVolumeOffset);
}

float keptRootAt(vec3 position, int light)
{
#if SHADOWED_LIGHTS > 4
  vec3 texel = position * scene_shadowVolumeScale + scene_shadowVolumeOffset;
  texel.z += scene_lightShadowVolume[light].x;
  return dot(texture(scene_shadowVolume, texel), scene_lightShadowComponent[light]);
#endif
  return dot(keptRoots, scene_lightShadowComponent[light]);
}

float shadowDepth(vec3 position, int light, ShadowSegment towardsLight, float largest)
{
  float root = keptRootAt(position, light);
  return largest * root * root +
    nearShadowDepth(position, towardsLight, scene_lightShadowVolume[light].y);
}
