// Two planes an axis cut the volume into 27 regions, each shown or hidden (vtkVolumeMapper's
// cropping region flags). A segment is cut where it first crosses a plane, so that a region ends at
// its border and not at a sample.

uniform vec3 scene_croppingLow;
uniform vec3 scene_croppingHigh;
uniform int scene_croppingFlags;

float croppingShows(vec3 position)
{
  ivec3 side = ivec3(greaterThan(position, scene_croppingLow)) + ivec3(greaterThan(position, scene_croppingHigh));
  int region = side.x + 3 * side.y + 9 * side.z;
  return float((scene_croppingFlags >> region) & 1);
}

// Fraction of the segment at which it crosses the plane of one axis, 1 where it does not.
vec3 crossingOf(vec3 plane, vec3 begin, vec3 segment)
{
  vec3 fraction = (plane - begin) * reciprocalDirection(segment);
  return mix(vec3(1.0), fraction, lessThan(abs(fraction - 0.5), vec3(0.5)));
}

float shownByCropping(inout vec3 position, vec3 segment)
{
  vec3 begin = position - 0.5 * segment;
  vec3 crossing = min(
    crossingOf(scene_croppingLow, begin, segment), crossingOf(scene_croppingHigh, begin, segment));
  float cut = min(crossing.x, min(crossing.y, crossing.z));
  float first = cut * croppingShows(begin + 0.5 * cut * segment);
  float second = (1.0 - cut) * croppingShows(begin + 0.5 * (1.0 + cut) * segment);
  float shown = first + second;
  float middle = shown > 0.0 ? (first * 0.5 * cut + second * 0.5 * (1.0 + cut)) / shown : 0.5;
  position = begin + middle * segment;
  return shown;
}
