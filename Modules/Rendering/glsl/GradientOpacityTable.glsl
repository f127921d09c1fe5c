// Factor of the extinction by the gradient's magnitude in the own frame, in scalar units per mean
// voxel.

uniform sampler1D scene_gradientOpacity;
uniform mat3 scene_gradientToTable;      // difference per voxel to the table's range
uniform float scene_gradientTableOffset; // of a gradient of 0, in the table's range

float gradientOpacityAt(vec3 position)
{
  float magnitude = length(scene_gradientToTable * gradientAt(position));
  float entries = float(textureSize(scene_gradientOpacity, 0));
  float root = sqrt(clamp(magnitude + scene_gradientTableOffset, 0.0, 1.0));
  return texture(scene_gradientOpacity, (root * (entries - 1.0) + 0.5) / entries).r;
}
