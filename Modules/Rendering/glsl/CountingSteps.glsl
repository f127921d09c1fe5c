// Counts what rays do, in red, green and blue in place of the colour. Alpha goes on as ever: it
// ends rays.

vec3 counted = vec3(0.0); // samples of view rays, those of them that are shaded, steps of shadow rays

void countSample()
{
  counted.x += 1.0;
}

void countShadedSample()
{
  counted.y += 1.0;
}

// Shadow rays take steps by fours. Those beyond the end have no length.
void countShadowStep(float stepLength)
{
  counted.z += stepLength > 0.0 ? 1.0 : 0.0;
}

vec4 written(vec4 before, vec4 accumulated)
{
  return vec4(before.rgb + counted, accumulated.a);
}
