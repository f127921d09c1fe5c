// Some layers of one light's opacity shadow map (Kim and Neumann 2001): how dark it has grown along
// the ray of each texel, at one distance after another. The optical depth so far is handed on from
// draw to draw.

uniform float scene_mapTexels;       // along the map, a border of one around it included
uniform int scene_mapLayer;          // this draw's first
uniform float scene_mapFirst;        // distance of the layer before it
uniform float scene_mapSpacing;      // from layer to layer
uniform sampler2D scene_depthBefore; // at the layer before

float depthBetween(MapRay ray, inout RayEnd rayEnd, float from, float to)
{
  float begin = clamp(from, ray.begin, ray.end);
  float between = clamp(to, ray.begin, ray.end) - begin;
  int steps = int(ceil(between / scene_shadowSampleDistance - 1e-3));
  float stepLength = between / float(max(steps, 1));
  float depth = 0.0;
  int step = 0;
  do
  {
    float at = min((float(step) + 0.5) * stepLength, between);
    vec3 middle = ray.origin + ray.direction * (begin + at);
    SegmentMatter matter;
    depth += segmentDepth(rayEnd, middle, ray.direction, step < steps ? stepLength : 0.0, matter);
  } while (++step < steps);
  return depth;
}

void main()
{
  MapRay ray = mapRayAt((texCoord * scene_mapTexels - 1.0) / (scene_mapTexels - 2.0));
  float valid = ray.begin < ray.end ? 1.0 : 0.0;
  ray.end = max(ray.begin, ray.end);
  float depth = scene_mapLayer > 0 ? texelFetch(scene_depthBefore, ivec2(gl_FragCoord.xy), 0).r : 0.0;
  float distance = clamp(scene_mapFirst, ray.begin, ray.end);
  vec3 segment = ray.direction * scene_mapSpacing;
  int empty = emptySteps(ray.origin + ray.direction * distance + 0.5 * segment, segment);
  bool same = empty >= LAYERS_PER_DRAW || depth >= scene_mapLargestDepth;
  RayEnd rayEnd = rayEndAt(ray.origin + ray.direction * distance);
  float darkness[LAYERS_PER_DRAW];
  for (int layer = 0; layer < LAYERS_PER_DRAW; ++layer)
  {
    darkness[layer] = darknessOf(depth);
  }
  int layer = 0;
  do
  {
    float from = scene_mapFirst + float(layer) * scene_mapSpacing;
    depth += depthBetween(ray, rayEnd, from, from + (same ? 0.0 : scene_mapSpacing));
    darkness[layer] = darknessOf(depth);
  } while (++layer < LAYERS_PER_DRAW && !same);
  // VTK knows outputs by literal numbers only: LAYERS_PER_DRAW of them, and the depth.
  gl_FragData[0] = vec4(darkness[0], valid, 0.0, 0.0);
  gl_FragData[1] = vec4(darkness[1], valid, 0.0, 0.0);
  gl_FragData[2] = vec4(darkness[2], valid, 0.0, 0.0);
  gl_FragData[3] = vec4(darkness[3], valid, 0.0, 0.0);
  gl_FragData[4] = vec4(darkness[4], valid, 0.0, 0.0);
  gl_FragData[5] = vec4(darkness[5], valid, 0.0, 0.0);
  gl_FragData[6] = vec4(darkness[6], valid, 0.0, 0.0);
  gl_FragData[7] = vec4(depth);
}
