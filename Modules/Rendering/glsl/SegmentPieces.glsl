// What is seen of a step that is lit: the scalar along it is taken for the parabola through its
// ends and its middle, cut into four pieces along which it changes evenly. What the pieces hide of
// each other counts in the step's colour, and the step is lit where the matter is that is seen of
// it.

struct SeenSegment
{
  vec3 position;
  vec3 color;
  float weight;
};

// Sums are weighted by what is seen of the pieces so far.
struct SeenPieces
{
  vec3 color;
  float place; // along the step, from -1/2 to 1/2
  float weight;
};

void seePiece(SegmentMatter piece, float place, vec4 before, inout SeenPieces seen)
{
  bool steep;
  float depth = meanExtinction(piece, steep) * piece.length;
  before.a += seen.weight * CompositedAlpha;
  float weight = compositingWeight(before, depth);
  seen.color += weight * segmentColor(piece);
  seen.place += weight * place;
  seen.weight += weight;
}

SeenSegment seenSegment(vec4 accumulated, SegmentMatter matter, vec3 position, vec3 segment)
{
  RayEnd middle = rayEndAt(position);
  vec3 scalars = vec3(matter.from.coordinate, middle.coordinate, matter.to.coordinate);
  float least = min(scalars.x, min(scalars.y, scalars.z));
  float most = max(scalars.x, max(scalars.y, scalars.z));
  RayEnd before = rayEndOf(clamp(dot(scalars, vec3(0.375, 0.75, -0.125)), least, most));
  RayEnd after = rayEndOf(clamp(dot(scalars, vec3(-0.125, 0.75, 0.375)), least, most));
  float pieceLength = 0.25 * matter.length;
  SeenPieces seen = SeenPieces(vec3(0.0), 0.0, 0.0);
  seePiece(SegmentMatter(matter.from, before, pieceLength), -0.375, accumulated, seen);
  seePiece(SegmentMatter(before, middle, pieceLength), -0.125, accumulated, seen);
  seePiece(SegmentMatter(middle, after, pieceLength), 0.125, accumulated, seen);
  seePiece(SegmentMatter(after, matter.to, pieceLength), 0.375, accumulated, seen);
  float share = seen.weight > 0.0 ? 1.0 / seen.weight : 0.0;
  return SeenSegment(position + share * seen.place * segment, share * seen.color, seen.weight);
}
