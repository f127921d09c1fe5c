// No light has a diffuse or specular term to add.

uniform vec3 scene_ambient; // sum of the lights' ambient colours times the material's factor

vec3 shadedColor(vec3 position, vec3 color, vec3 view)
{
  return clamp(color * scene_ambient, 0.0, 1.0);
}
