// The steps that a view ray is cut into, of the sample distance each, the last one shorter.

struct ViewRay
{
  vec3 entry;     // where its first step begins
  vec3 direction; // texture coordinates per length
  float length;
  vec3 view;      // towards the eye, in the world
};

// A ray ends where it has become opaque enough. What lies behind is taken to have the colour of what
// lies before.
uniform float scene_opaqueEnough;

float stepLengthOf(ViewRay ray, int index)
{
  return min(scene_sampleDistance, ray.length - float(index) * scene_sampleDistance);
}

vec3 stepMiddle(ViewRay ray, int index)
{
  float begin = float(index) * scene_sampleDistance;
  return ray.entry + ray.direction * (begin + 0.5 * stepLengthOf(ray, index));
}
