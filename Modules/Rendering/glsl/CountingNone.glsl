void countSample() {}
void countShadedSample() {}
void countShadowStep(float stepLength) {}

vec4 written(vec4 before, vec4 accumulated)
{
  return accumulated;
}
