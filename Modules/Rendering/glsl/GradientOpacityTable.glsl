// Factor of the extinction by the gradient's magnitude in the own frame, in scalar units per mean voxel.

uniform sampler1D scene_gradientOpacity;
uniform mat3 scene_gradientToTable;      // difference per voxel to the table's coordinate
uniform float scene_gradientTableOffset; // coordinate of a gradient of 0

float gradientOpacityAt(vec3 position)
{
  float magnitude = length(scene_gradientToTable * gradientAt(position));
  return texture(scene_gradientOpacity, magnitude + scene_gradientTableOffset).r;
}
