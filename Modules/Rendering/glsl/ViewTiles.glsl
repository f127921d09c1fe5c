//VTK::System::Dec

// The picture's tiles that matter is seen in, in place of the box's triangles: rays that would find
// nothing are not begun. Each triangle makes some of them; what is drawn of the box has twelve or
// more.

const int TilesPerTriangle = 16;

layout(triangles) in;
layout(triangle_strip, max_vertices = 64) out;

uniform int scene_tiles; // how many; -1: the box is drawn as it is
uniform vec4 scene_tile[12 * TilesPerTriangle]; // low and high corner

void emitCorner(vec4 position)
{
  gl_Position = position;
  EmitVertex();
}

void main()
{
  if (scene_tiles < 0)
  {
    emitCorner(gl_in[0].gl_Position);
    emitCorner(gl_in[1].gl_Position);
    emitCorner(gl_in[2].gl_Position);
    EndPrimitive();
  }
  int first = gl_PrimitiveIDIn * TilesPerTriangle;
  for (int tile = first; tile < min(first + TilesPerTriangle, scene_tiles); ++tile)
  {
    vec4 corners = scene_tile[tile];
    emitCorner(vec4(corners.xy, -1.0, 1.0));
    emitCorner(vec4(corners.zy, -1.0, 1.0));
    emitCorner(vec4(corners.xw, -1.0, 1.0));
    emitCorner(vec4(corners.zw, -1.0, 1.0));
    EndPrimitive();
  }
}
