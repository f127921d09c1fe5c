// The ray of a texel of a light's map, as far as matter is visible along it.

in vec2 texCoord;
uniform mat4 scene_lightToTexture;
uniform int scene_mapProjection;
uniform float scene_mapExtent;
uniform float scene_mapLargestDepth; // that is told apart

struct MapRay
{
  vec3 origin;
  vec3 direction;
  float begin;
  float end; // before it begins: the ray passes beside the matter
};

MapRay mapRayAt(vec2 place)
{
  vec3 origin;
  vec3 direction;
  mapRayOf(place, scene_mapProjection, scene_mapExtent, origin, direction);
  MapRay ray;
  ray.origin = (scene_lightToTexture * vec4(origin, 1.0)).xyz;
  ray.direction = (scene_lightToTexture * vec4(direction, 0.0)).xyz;
  vec2 visible = keptByPlanes(insideBox(ray.origin, ray.direction), ray.origin, ray.direction);
  ray.begin = max(visible.x, 0.0);
  ray.end = visible.y;
  return ray;
}

float darknessOf(float depth)
{
  return sqrt(min(depth / scene_mapLargestDepth, 1.0));
}
