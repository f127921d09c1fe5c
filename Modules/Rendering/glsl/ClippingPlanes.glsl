// The part of a ray on the side of every clipping plane that its normal points to. What the planes
// keep is convex, so the part is one interval, and its border is exact.

uniform vec4 scene_clippingPlanes[CLIPPING_PLANES]; // texture coordinates; dot(plane, (p, 1)) >= 0 is kept

vec2 keptByPlanes(vec2 interval, vec3 position, vec3 direction)
{
  int plane = 0;
  do
  {
    float height = dot(scene_clippingPlanes[plane], vec4(position, 1.0));
    float slope = dot(scene_clippingPlanes[plane].xyz, direction);
    if (slope > 0.0)
    {
      interval.x = max(interval.x, -height / slope);
    }
    else if (slope < 0.0)
    {
      interval.y = min(interval.y, -height / slope);
    }
    else if (height < 0.0)
    {
      interval.y = interval.x;
    }
  } while (++plane < CLIPPING_PLANES);
  return interval;
}
