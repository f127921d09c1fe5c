// c = C ka sum(Ia) + C kd Ed(N) + ks Es(R): the surroundings, filtered by the cosine and by its
// power, are seen at the normal N and at R, the direction to the eye mirrored at it (Miller and
// Hoffman 1984).

uniform vec3 scene_ambient; // sum of the lights' ambient colours times the material's factor

vec3 shadedColor(vec3 position, vec3 color, vec3 view)
{
  ShadedPoint point = shadedPoint(position, gradientAt(position), view);
  vec3 diffuse = scene_ambient;
  vec3 specular = vec3(0.0);
  if (reflects(point))
  {
    diffuse += environmentDiffuse(point);
    specular = environmentSpecular(point);
  }
  return clamp(color * diffuse + specular, 0.0, 1.0);
}
