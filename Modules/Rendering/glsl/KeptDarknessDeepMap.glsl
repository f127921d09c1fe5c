// A deep shadow map (Lokovic and Veach 2000): a texel holds how dark it grows along its ray, as a
// piecewise linear function of eight nodes, two of distance and darkness to a slice's texel. The
// functions of the four rays around a point are averaged, weighted by how near they are.

uniform sampler3D scene_shadowMaps;

const int MapSlices = 4;

float darknessAlongRay(ivec3 texel, float distance, out float valid)
{
  vec4 nodes = texelFetch(scene_shadowMaps, texel, 0);
  valid = nodes.x >= 0.0 ? 1.0 : 0.0;
  float darkness = 0.0;
  for (int slice = 1; ; ++slice)
  {
    darkness = mix(nodes.y, nodes.w, clamp((distance - nodes.x) / max(nodes.z - nodes.x, 1e-20), 0.0, 1.0));
    if (slice == MapSlices || distance <= nodes.z)
    {
      return darkness;
    }
    vec4 next = texelFetch(scene_shadowMaps, texel + ivec3(0, 0, slice), 0);
    if (distance < next.x)
    {
      return mix(nodes.w, next.y, (distance - nodes.z) / (next.x - nodes.z));
    }
    nodes = next;
  }
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
  for (int corner = 0; corner < 4; ++corner)
  {
    ivec2 side = ivec2(corner & 1, corner >> 1);
    vec2 weight = mix(1.0 - part, part, vec2(side));
    float valid;
    float darkness =
      darknessAlongRay(ivec3(wrappedTexel(first + side, size, projection), slice), distance, valid);
    sum += valid * weight.x * weight.y * darkness;
    weights += valid * weight.x * weight.y;
  }
  return sum / weights;
}
