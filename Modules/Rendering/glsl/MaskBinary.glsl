// A voxel of the mask hides all that is nearest to it. A segment is cut at the first face of a
// voxel that it crosses on each axis; the sample moves to the middle of what is shown. For segments
// up to one voxel this is exact at the mask's border.

uniform sampler3D scene_mask;

float maskShows(vec3 voxel)
{
  ivec3 size = textureSize(scene_mask, 0);
  ivec3 nearest = clamp(ivec3(floor(voxel)), ivec3(0), size - 1);
  return texelFetch(scene_mask, nearest, 0).r > 0.0 ? 1.0 : 0.0;
}

float shownByMask(inout vec3 position, vec3 segment)
{
  vec3 size = vec3(textureSize(scene_mask, 0));
  vec3 begin = (position - 0.5 * segment) * size;
  vec3 extent = segment * size;
  vec3 face = mix(ceil(begin) - 1.0, floor(begin) + 1.0, greaterThan(extent, vec3(0.0)));
  vec3 cut = clamp((face - begin) * reciprocalDirection(extent), 0.0, 1.0);
  float first = min(cut.x, min(cut.y, cut.z));
  float last = max(cut.x, max(cut.y, cut.z));
  float second = cut.x + cut.y + cut.z - first - last;

  vec4 from = vec4(0.0, first, second, last);
  vec4 to = vec4(first, second, last, 1.0);
  vec4 middle = 0.5 * (from + to);
  vec4 shown = (to - from) *
    vec4(maskShows(begin + middle.x * extent), maskShows(begin + middle.y * extent),
      maskShows(begin + middle.z * extent), maskShows(begin + middle.w * extent));
  float total = dot(shown, vec4(1.0));
  float center = total > 0.0 ? dot(shown, middle) / total : 0.5;
  position += (center - 0.5) * segment;
  return total;
}
