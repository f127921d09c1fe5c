// A normal is as certain as its gradient stands out from noise: w = 1 - exp(-(|g| / (k s))^2), s
// the root mean square of what noise alone gives. The rest is reflected as by normals of all
// directions.

uniform mat3 scene_gradientToNoise;  // difference per voxel to multiples of k s
uniform float scene_fadedReflection; // mean of N.L over all normals
uniform vec3 scene_fadedRadiance;    // and of the environment's

struct ShadedPoint
{
  vec3 position;
  vec3 normal;
  vec3 view; // world, towards the eye
  float certainty;
};

ShadedPoint shadedPoint(vec3 position, vec3 gradient, vec3 view)
{
  vec3 multiple = min(abs(scene_gradientToNoise * gradient), vec3(1e9));
  vec3 normal = normalOf(gradient);
  // Without a gradient any will do, for none of it counts.
  normal = normal == vec3(0.0) ? view : normal;
  return ShadedPoint(position, normal, view, 1.0 - exp(-dot(multiple, multiple)));
}

bool reflects(ShadedPoint point)
{
  return true;
}

float fadedDiffuse(ShadedPoint point, float reflection)
{
  return mix(scene_fadedReflection, reflection, point.certainty);
}

float fadedSpecular(ShadedPoint point, float reflection)
{
  return reflection * point.certainty;
}

vec3 fadedRadiance(ShadedPoint point, vec3 radiance)
{
  return mix(scene_fadedRadiance, radiance, point.certainty);
}
