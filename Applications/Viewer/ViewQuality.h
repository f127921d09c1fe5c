/**
 * @class   ViewQuality
 * @brief   how coarse the picture has to be for the view to stay fluid
 *
 * While something moves, rays are cast through every n-th pixel along each axis. What a ray sees is
 * the same, so that refining changes no brightness.
 */

#ifndef ViewQuality_h
#define ViewQuality_h

namespace penumbra
{

class ViewQuality
{
public:
  static constexpr int LargestDistance = 8;

  /// A frame with one ray in `distance` x `distance` pixels took this long, of which `kept` were
  /// spent on what does not depend on rays, as shadows that are kept.
  void NoteFrame(double seconds, double kept, int distance);

  /// A whole frame with all that a still picture has took this long, which bounds what is expected
  /// of one of what moves.
  void NoteStill(double seconds);

  /// The smallest distance between rays, 1 to LargestDistance pixels, by which about `rate` frames
  /// a second can be drawn, going by the frame before.
  int FindDistance(double rate) const;

  /// What a frame of all pixels takes, in seconds.
  double GetSecondsOfWholeFrame() const { return this->SecondsOfRays + this->SecondsOfKept; }

private:
  double SecondsOfRays = 0.0;
  double SecondsOfKept = 0.0;
};

}

#endif
