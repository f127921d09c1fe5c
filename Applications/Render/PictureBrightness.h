/**
 * @file    PictureBrightness.h
 * @brief   whether something is seen in a picture: how much, how bright, and what is lost in it
 */

#ifndef PictureBrightness_h
#define PictureBrightness_h

class vtkImageData;

namespace penumbra
{

/// Of the pixels that the volume covers, which are those with an alpha above 0.03.
struct PictureBrightness
{
  /// The part of the picture's pixels that they are, 0 to 1. Where it is 0, so is the rest.
  double Foreground = 0.0;
  /// Mean relative luminance (ITU-R BT.709) of the picture's values, 0 to 1.
  double Luminance = 0.0;
  /// The part of them with a channel at its limit, 0.995 or above.
  double BurntOut = 0.0;
  /// The part of them with a luminance below 0.05.
  double Black = 0.0;
};

/// `picture` is one that EncodePicture takes; a background other than black shines through.
PictureBrightness MeasureBrightness(vtkImageData* picture);

}

#endif
