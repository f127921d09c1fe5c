// Rays of a light as places on its map: of parallel rays, of rays from a point within a cone, or of
// rays from a point all around, by octahedral coordinates (Meyer et al. 2010).

const int ParallelRays = 0;
const int PerspectiveRays = 1;
const int OctahedralRays = 2;

vec2 foldedOver(vec2 octahedral)
{
  return (1.0 - abs(octahedral.yx)) * mix(vec2(-1.0), vec2(1.0), greaterThanEqual(octahedral, vec2(0.0)));
}

// Place on the map and distance from where the map begins of a point in the light's frame.
vec3 mapPlaceOf(vec3 point, int projection, float extent)
{
  if (projection == ParallelRays)
  {
    return point;
  }
  float distance = length(point);
  if (projection == PerspectiveRays)
  {
    return vec3(0.5 + 0.5 * point.xy / (extent * point.z), distance);
  }
  vec3 octahedral = point / max(abs(point.x) + abs(point.y) + abs(point.z), 1e-30);
  vec2 place = octahedral.z < 0.0 ? foldedOver(octahedral.xy) : octahedral.xy;
  return vec3(0.5 + 0.5 * place, distance);
}

// A ray of a place on the map, in the light's frame.
void mapRayOf(vec2 place, int projection, float extent, out vec3 origin, out vec3 direction)
{
  origin = projection == ParallelRays ? vec3(place, 0.0) : vec3(0.0);
  direction = vec3(0.0, 0.0, 1.0);
  vec2 centred = 2.0 * place - 1.0;
  if (projection == PerspectiveRays)
  {
    direction = normalize(vec3(centred * extent, 1.0));
  }
  else if (projection == OctahedralRays)
  {
    float z = 1.0 - abs(centred.x) - abs(centred.y);
    direction = normalize(vec3(z < 0.0 ? foldedOver(centred) : centred, z));
  }
}
