// The root of the optical depth towards one light, over the largest that is told apart, at the
// texel centres of one slice of the shadow volume, by a shadow ray from each. A texel in matter
// that is hidden holds what a ray sees from where matter is visible again, so that samples beside
// it interpolate what they would see themselves.

in vec2 texCoord;
uniform vec3 scene_shadowTexels;       // their number along each axis, at least 2
uniform float scene_shadowSlice;
uniform vec4 scene_shadowLight;        // position and 1, or direction of the shadow ray and 0
uniform vec2 scene_shadowRay;          // where it begins; the largest optical depth

void main()
{
  vec3 texel = vec3(texCoord * scene_shadowTexels.xy - 0.5, scene_shadowSlice);
  vec3 position = mix(scene_boxLow, scene_boxHigh, texel / (scene_shadowTexels - 1.0));
  if (emptyAround(position, (scene_boxHigh - scene_boxLow) / (scene_shadowTexels - 1.0)))
  {
    // No sample looks here.
    gl_FragData[0] = vec4(0.0);
    return;
  }
  vec3 direction = scene_shadowLight.xyz;
  float end = 1e30;
  if (scene_shadowLight.w > 0.0)
  {
    vec3 toLight = scene_shadowLight.xyz - position;
    end = length(scene_textureToOwn * toLight);
    direction = end > 0.0 ? toLight / end : vec3(0.0);
  }
  float entry = keptByPlanes(insideBox(position, direction), position, direction).x;
  float depth =
    opticalDepth(position, direction, max(scene_shadowRay.x, entry), end, scene_shadowRay.y);
  gl_FragData[0] = vec4(sqrt(min(depth / scene_shadowRay.y, 1.0)));
}
