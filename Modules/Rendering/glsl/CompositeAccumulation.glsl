//VTK::System::Dec
//VTK::Output::Dec

// Puts the gathered picture over what the viewport holds, stretched where it has fewer pixels.

in vec2 texCoord;
uniform sampler2D scene_accumulated;

void main()
{
  gl_FragData[0] = texture(scene_accumulated, texCoord);
}
