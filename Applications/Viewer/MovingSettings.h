/**
 * @class   MovingSettings
 * @brief   while it lives, a mapper draws as suits pictures of what moves
 *
 * Steps are twice as long, and shadows are looked up in coarse opacity maps, which are made anew in
 * a few hundredths of a second. The rays that are saved thereby show more than fine steps would.
 * Opacity is corrected for the step, so that brightness stays.
 */

#ifndef MovingSettings_h
#define MovingSettings_h

class vtkIlluminatedVolumeMapper;

namespace penumbra
{

class MovingSettings
{
public:
  /// Texels across the volume of the shadows that are kept for a moving picture.
  static constexpr double TexelsOfShadows = 200.0;
  static constexpr double LongerSteps = 2.0;

  /// With `ownShadows`, shadows are kept for moving pictures alone; else as they are. No mapper is
  /// none of it.
  MovingSettings(vtkIlluminatedVolumeMapper* mapper, bool ownShadows);
  ~MovingSettings();
  MovingSettings(const MovingSettings&) = delete;
  MovingSettings& operator=(const MovingSettings&) = delete;

private:
  vtkIlluminatedVolumeMapper* Mapper;
  float SampleDistance = 0.0f;
  double ShadowSampleDistance = 0.0;
  int Technique = 0;
  double Resolution = 0.0;
};

}

#endif
