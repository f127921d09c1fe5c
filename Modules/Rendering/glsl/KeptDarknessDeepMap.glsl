// A deep shadow map (Lokovic and Veach 2000): a texel holds how dark it grows along its ray, as a
// piecewise linear function of eight nodes, two of distance and darkness to a slice's texel. The
// functions of the four rays around a point are averaged, weighted by how near they are.

uniform sampler3D scene_shadowMaps;

const int MapSlices = 4;

float partBetween(float begin, float end, float distance)
{
  return clamp((distance - begin) / max(end - begin, 1e-20), 0.0, 1.0);
}

float darknessAlongRay(ivec3 texel, float distance, out float valid)
{
  float darkness = 0.0;
  vec2 before = vec2(0.0);
  int slice = 0;
  do
  {
    vec4 nodes = texelFetch(scene_shadowMaps, texel + ivec3(0, 0, slice), 0);
    bool first = slice == 0;
    valid = first ? step(0.0, nodes.x) : valid;
    float gap = mix(before.y, nodes.y, first ? 1.0 : partBetween(before.x, nodes.x, distance));
    float within = mix(nodes.y, nodes.w, partBetween(nodes.x, nodes.z, distance));
    float here = distance < nodes.x ? gap : within;
    darkness = first || distance > before.x ? here : darkness;
    before = nodes.zw;
  } while (++slice < MapSlices && distance > before.x);
  return darkness;
}

// Beyond the border of an octahedral map it goes on mirrored; beyond that of others there is
// nothing.
ivec2 wrappedTexel(ivec2 texel, int size, int projection)
{
  if (projection == OctahedralRays)
  {
    texel = texel.x < 0 || texel.x >= size ? ivec2(clamp(texel.x, 0, size - 1), size - 1 - texel.y) : texel;
    texel = texel.y < 0 || texel.y >= size ? ivec2(size - 1 - texel.x, clamp(texel.y, 0, size - 1)) : texel;
  }
  return clamp(texel, ivec2(0), ivec2(size - 1));
}

float keptDarkness(vec3 position, int light, float before)
{
  vec3 place = lightMapPlace(position, light);
  int projection = mapProjection(light);
  float distance = place.z - before;
  int size = textureSize(scene_shadowMaps, 0).x;
  vec2 texel = place.xy * float(size) - 0.5;
  ivec2 first = ivec2(floor(texel));
  vec2 part = texel - vec2(first);
  int slice = MapSlices * int(scene_lightMap[light].x);
  float sum = 0.0;
  float weights = 1e-6;
  int corner = 0;
  do
  {
    ivec2 side = ivec2(corner & 1, corner >> 1);
    vec2 weight = mix(1.0 - part, part, vec2(side));
    float valid;
    float darkness =
      darknessAlongRay(ivec3(wrappedTexel(first + side, size, projection), slice), distance, valid);
    sum += valid * weight.x * weight.y * darkness;
    weights += valid * weight.x * weight.y;
  } while (++corner < 4);
  return sum / weights;
}
