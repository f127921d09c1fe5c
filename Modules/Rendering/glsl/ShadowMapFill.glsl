// One light's deep shadow map: along the ray of each texel the darkness, as the piecewise linear
// function of eight nodes or fewer that stays within a tolerance of it (Lokovic and Veach 2000).
// The tolerance grows where eight are too few. Or a shadow map: two nodes, at the first hit.

uniform float scene_mapFirstHit; // optical depth of it; less than 0: none is made
uniform float scene_mapTolerance;

const int Nodes = 8;
const float Nowhere = 1e30;
const float WidestTolerance = 1.0; // that every function is within

float mapStepBegin(MapRay ray, int step)
{
  return ray.begin + float(step) * scene_shadowSampleDistance;
}

// A step's optical depth, or that of a leap over empty space, which has none; the step behind it.
float mapStepDepth(inout RayEnd rayEnd, MapRay ray, inout int step)
{
  float at = mapStepBegin(ray, step);
  float stepLength = min(scene_shadowSampleDistance, ray.end - at);
  vec3 middle = ray.origin + ray.direction * (at + 0.5 * stepLength);
  int leap = emptySteps(middle, ray.direction * scene_shadowSampleDistance);
  SegmentMatter matter;
  float depth = segmentDepth(rayEnd, middle, ray.direction, stepLength, matter);
  // Of a leap this step was the first.
  step += 1 + leapOver(max(leap - 1, 0), rayEnd);
  return leap > 0 ? 0.0 : depth;
}

// The least and the largest slope from a node to within the tolerance of a point.
vec2 slopesTo(vec2 node, vec2 point, float tolerance)
{
  float run = max(point.x - node.x, 1e-20);
  return vec2(max(point.y - tolerance - node.y, 0.0), point.y + tolerance - node.y) / run;
}

// The last step's end before a point, of those that a leap has passed over, that the flattest line
// from a node comes within the tolerance of.
vec2 lastWithin(vec2 node, vec2 before, vec2 here, vec2 slopes, float tolerance)
{
  float reach = slopes.x > 0.0 ? node.x + (before.y + tolerance - node.y) / slopes.x : before.x;
  float steps = floor((min(reach, here.x) - before.x) / scene_shadowSampleDistance);
  float passed = floor((here.x - before.x) / scene_shadowSampleDistance - 0.5);
  return vec2(before.x + clamp(steps, 0.0, max(passed, 0.0)) * scene_shadowSampleDistance, before.y);
}

// False where the nodes are too few. Every line from the last node keeps within the slopes so far;
// the first point that none of them reaches makes a node of the point before it.
bool followDarkness(MapRay ray, float tolerance, out vec2 node[Nodes])
{
  for (int i = 0; i < Nodes; ++i)
  {
    node[i] = vec2(ray.begin, 0.0);
  }
  int last = 0;
  vec2 slopes = vec2(0.0, Nowhere);
  vec2 before = node[0];
  float depth = 0.0;
  RayEnd rayEnd = rayEndAt(ray.origin + ray.direction * ray.begin);
  int step = 0;
  while (mapStepBegin(ray, step) < ray.end && depth < scene_mapLargestDepth)
  {
    depth += mapStepDepth(rayEnd, ray, step);
    vec2 here = vec2(min(mapStepBegin(ray, step), ray.end), darknessOf(depth));
    vec2 reaching = slopesTo(node[last], here, tolerance);
    vec2 both = vec2(max(slopes.x, reaching.x), min(slopes.y, reaching.y));
    if (both.x > both.y)
    {
      before = lastWithin(node[last], before, here, slopes, tolerance);
      vec2 nearer = slopesTo(node[last], before, tolerance);
      slopes = vec2(max(slopes.x, nearer.x), min(slopes.y, nearer.y));
      if (last == Nodes - 2)
      {
        return false;
      }
      vec2 next = vec2(before.x, node[last].y + 0.5 * (slopes.x + slopes.y) * (before.x - node[last].x));
      node[++last] = next;
      both = slopesTo(next, here, tolerance);
    }
    slopes = both;
    before = here;
  }
  float rise = slopes.y < Nowhere ? 0.5 * (slopes.x + slopes.y) * (before.x - node[last].x) : 0.0;
  vec2 end = vec2(before.x, min(node[last].y + rise, 1.0));
  node[++last] = end;
  for (int i = 0; i < Nodes; ++i)
  {
    node[i] = i > last ? vec2(Nowhere, end.y) : node[i];
  }
  return true;
}

// By the least tolerance that the nodes are enough for, within a third of it.
void followAsNear(MapRay ray, out vec2 node[Nodes])
{
  float enough = scene_mapTolerance;
  float tooLittle = scene_mapTolerance;
  while (!followDarkness(ray, enough, node))
  {
    tooLittle = enough;
    enough = min(3.0 * enough, WidestTolerance);
  }
  while (enough > 1.35 * tooLittle)
  {
    float between = sqrt(tooLittle * enough);
    vec2 nearer[Nodes];
    if (followDarkness(ray, between, nearer))
    {
      node = nearer;
      enough = between;
    }
    else
    {
      tooLittle = between;
    }
  }
}

float firstHit(MapRay ray)
{
  float depth = 0.0;
  RayEnd rayEnd = rayEndAt(ray.origin + ray.direction * ray.begin);
  int step = 0;
  while (mapStepBegin(ray, step) < ray.end)
  {
    float at = mapStepBegin(ray, step);
    float added = mapStepDepth(rayEnd, ray, step);
    if (depth + added > scene_mapFirstHit)
    {
      float stepLength = min(mapStepBegin(ray, step), ray.end) - at;
      return at + stepLength * (scene_mapFirstHit - depth) / added;
    }
    depth += added;
  }
  return Nowhere;
}

void main()
{
  MapRay ray = mapRayAt(texCoord);
  vec2 node[Nodes];
  if (ray.end <= ray.begin)
  {
    // A ray beside the matter tells nothing.
    node[0] = vec2(-1.0, 0.0);
  }
  else if (scene_mapFirstHit >= 0.0)
  {
    float hit = firstHit(ray);
    node[0] = vec2(hit, 0.0);
    node[1] = vec2(hit, hit < Nowhere ? 1.0 : 0.0);
    node[2] = vec2(Nowhere, node[1].y);
    node[3] = node[2];
  }
  else
  {
    followAsNear(ray, node);
  }
  gl_FragData[0] = vec4(node[0], node[1]);
  gl_FragData[1] = vec4(node[2], node[3]);
  gl_FragData[2] = vec4(node[4], node[5]);
  gl_FragData[3] = vec4(node[6], node[7]);
}
