// Factor of the extinction by the gradient's magnitude in the own frame, in scalar units per mean voxel.

uniform sampler1D scene_gradientOpacity;
uniform mat3 scene_gradientToMagnitude;     // difference per voxel to scalar units per mean voxel
uniform vec2 scene_gradientOpacityCoordinate;

float gradientOpacityAt(vec3 position)
{
  float magnitude = length(scene_gradientToMagnitude * gradientAt(position));
  return texture(scene_gradientOpacity,
    magnitude * scene_gradientOpacityCoordinate.x + scene_gradientOpacityCoordinate.y).r;
}
