/**
 * @file    InteractiveResolution.h
 * @brief   how many pixels fit into the time that an interactive frame may take
 *
 * The time of a frame is taken to grow with its number of pixels: from the last frame measured
 * follows the distance between rays, in pixels of the window, at which the next one meets its time.
 * Nothing but the number of rays changes, and so not the brightness.
 */

#ifndef InteractiveResolution_h
#define InteractiveResolution_h

#include "PenumbraRenderingModule.h" // For export macro

namespace penumbra
{

class PENUMBRARENDERING_EXPORT InteractiveResolution
{
public:
  /// Frames that may take longer are stills, drawn in full. In seconds.
  static constexpr double LongestInteractiveFrame = 5.0;
  /// In pixels of the window. Coarser pictures do not show what one moves.
  static constexpr double LargestDistance = 8.0;

  /// Whether a frame that may take this long is to be measured.
  static bool IsInteractive(double allocatedSeconds);

  /// Distance between rays for a frame that may take this long, at least 1. Before any frame was
  /// measured it is 1.
  double FindDistance(double allocatedSeconds) const;

  /// A frame with this distance between rays took that long.
  void Measure(double distance, double seconds);

private:
  double FullFrameSeconds = 0.0;
};

}

#endif
