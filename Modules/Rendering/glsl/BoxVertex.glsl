//VTK::System::Dec

// The box that stands for the volume. Its rasterization only finds the pixels; where a view ray
// enters and leaves is computed per fragment.

in vec3 in_vertexPos;
uniform mat4 scene_boxToClip;

void main()
{
  gl_Position = scene_boxToClip * vec4(in_vertexPos, 1.0);
}
