// Every normal is taken for certain, however faint its gradient.

struct ShadedPoint
{
  vec3 position;
  vec3 normal;
  vec3 view; // world, towards the eye
};

ShadedPoint shadedPoint(vec3 position, vec3 gradient, vec3 view)
{
  return ShadedPoint(position, normalOf(gradient), view);
}

bool reflects(ShadedPoint point)
{
  return point.normal != vec3(0.0);
}

float fadedDiffuse(ShadedPoint point, float reflection)
{
  return reflection;
}

float fadedSpecular(ShadedPoint point, float reflection)
{
  return reflection;
}

vec3 fadedRadiance(ShadedPoint point, vec3 radiance)
{
  return radiance;
}
