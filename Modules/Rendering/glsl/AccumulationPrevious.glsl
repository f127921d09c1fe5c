// A picture cut into several draws goes on with what the draws before this one gathered.

uniform sampler2D scene_accumulated;

vec4 accumulatedBefore()
{
  return texelFetch(scene_accumulated, ivec2(gl_FragCoord.xy), 0);
}
