// L = integral of s c T, front to back along the view ray from its entry (or from the eye, where
// that is inside) to its exit or to opaque geometry. The ray is cut into steps of the sample
// distance, the last one shorter; each sample lies in the middle of its step, so the sum converges
// with second order.

uniform vec2 scene_viewportOrigin;
uniform vec2 scene_viewportScale;       // 2 over the viewport's size
uniform mat3 scene_rayBase;             // image position (x, y, 1) to a point of the ray
uniform mat3 scene_rayDirection;        // and to its direction
uniform float scene_rayEye;             // the eye, in directions from the base
uniform vec4 scene_clipDepth;           // rows z and w of the map from texture to clip coordinates
uniform vec4 scene_clipW;
uniform sampler2D in_depthSampler;
uniform int scene_firstStep;            // the part of the ray that this draw marches
uniform int scene_lastStep;

const float NoOpaqueGeometry = 1e30;
float opaqueGeometryAt(vec2 image, vec3 base, vec3 direction)
{
  float depth = texture(in_depthSampler, 0.5 * image + 0.5).r;
  if (depth >= 1.0)
  {
    return NoOpaqueGeometry;
  }
  float z = 2.0 * depth - 1.0;
  float atBase = dot(scene_clipDepth, vec4(base, 1.0)) - z * dot(scene_clipW, vec4(base, 1.0));
  float perLength = dot(scene_clipDepth.xyz, direction) - z * dot(scene_clipW.xyz, direction);
  return -atBase / perLength;
}

void main()
{
  vec2 image = (gl_FragCoord.xy - scene_viewportOrigin) * scene_viewportScale - 1.0;
  vec3 base = scene_rayBase * vec3(image, 1.0);
  vec3 direction = scene_rayDirection * vec3(image, 1.0);
  float ownLength = length(scene_textureToOwn * direction);
  direction /= ownLength;
  vec3 view = -normalize(scene_textureToWorld * direction);

  vec2 inside = keptByPlanes(insideBox(base, direction), base, direction);
  inside.x = max(inside.x, scene_rayEye * ownLength);
  inside.y = min(inside.y, opaqueGeometryAt(image, base, direction));
  // A remainder that is rounding only is no step.
  float steps = ceil((inside.y - inside.x) / scene_sampleDistance - 1e-4);
  int last = int(clamp(steps, 0.0, float(scene_lastStep)));

  ViewRay ray = ViewRay(base + direction * inside.x, direction, inside.y - inside.x, view);
  vec4 before = accumulatedBefore();
  gl_FragData[0] = written(before, march(ray, scene_firstStep, last, before));
}
