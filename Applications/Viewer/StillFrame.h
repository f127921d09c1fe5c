/**
 * @class   StillFrame
 * @brief   one whole frame, drawn strip by strip, so that events are answered in between
 *
 * Every strip has the rays that the whole frame has there, and the picture is the same. What lies
 * over the volume is drawn once, at the end. Before the first strip, shadows that are kept are
 * computed piece by piece.
 */

#ifndef StillFrame_h
#define StillFrame_h

#include <vtkSmartPointer.h>

class vtkIlluminatedVolumeMapper;
class vtkRenderer;

namespace penumbra
{

class StillFrame
{
public:
  StillFrame() = default;
  ~StillFrame();
  StillFrame(const StillFrame&) = delete;
  StillFrame& operator=(const StillFrame&) = delete;

  /// The renderer has to be in a window and to show a volume with this mapper.
  void Begin(vtkRenderer* renderer, vtkIlluminatedVolumeMapper* mapper, int strips);

  /// About how long a draw may compute shadows, in seconds.
  static constexpr double SecondsOfShadows = 0.08;

  /// Draws a strip, from below upwards, or computes shadows. Returns whether all is drawn.
  bool DrawNext();

  /// Draws what lies over the volume, which stays as it is.
  void DrawOver();

  /// Leaves the frame as far as it is drawn.
  void End();

  bool IsRunning() const { return this->Renderer != nullptr; }
  /// In what has been drawn by now, without the time in between.
  double GetSeconds() const { return this->Seconds; }

private:
  void SetScissor(int below, int above);
  void ConfineToStrip();
  void Free();

  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkIlluminatedVolumeMapper> Mapper;
  unsigned long Confining = 0;
  unsigned long Freeing = 0;
  int Strips = 1;
  int Strip = 0;
  double Seconds = 0.0;
};

}

#endif
