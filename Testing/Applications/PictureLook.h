/**
 * @file    PictureLook.h
 * @brief   how much is seen in a picture of penumbra-render, measured from its file
 */

#ifndef PictureLook_h
#define PictureLook_h

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

struct PictureLook
{
  /// Of the picture, what the volume covers.
  double foreground = 0.0;
  /// Of what it covers: the mean luminance, and what is burnt out and black.
  double luminance = 0.0;
  double burntOut = 0.0;
  double black = 0.0;
  nlohmann::json report;
};

/// The look of the picture, 128 pixels wide and high, that penumbra-render makes of `arguments`.
PictureLook LookOf(std::vector<std::string> arguments);

/// What a picture over black has to be so that something is seen in it: neither dark nor burnt out,
/// and not lost in an empty picture.
void CheckIsSeen(const PictureLook& look, double leastForeground);

#endif
