// An opacity shadow map (Kim and Neumann 2001): texels tell how dark it has grown along their rays,
// at layers of one distance after another. The second component is 0 where a ray passes beside the
// visible matter and tells nothing; texels around the map's border hold what lies beyond it.

uniform sampler3D scene_opacityMaps;
uniform vec3 scene_opacityMapTexels;    // scale and offset from place to texture coordinates, the last
uniform vec4 scene_lightLayers[LIGHTS]; // scale and offset from distance to texture coordinate, its range

float keptDarkness(vec3 position, int light, float before)
{
  vec3 place = lightMapPlace(position, light);
  vec4 layers = scene_lightLayers[light];
  float layer = clamp((place.z - before) * layers.x + layers.y, layers.z, layers.w);
  vec2 texel = min(place.xy * scene_opacityMapTexels.x + scene_opacityMapTexels.y, scene_opacityMapTexels.z);
  vec2 kept = texture(scene_opacityMaps, vec3(texel, layer)).rg;
  return kept.r / max(kept.g, 1e-3);
}
