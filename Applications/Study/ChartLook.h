/**
 * @file    ChartLook.h
 * @brief   colours, markers and dashes of charts
 */

#ifndef ChartLook_h
#define ChartLook_h

#include <array>
#include <cstddef>
#include <vector>

namespace penumbra
{

/// Red, green and blue from 0 to 1.
using ChartColor = std::array<double, 3>;

/// Those of the contact sheets.
constexpr ChartColor ChartPaper{ 247 / 255.0, 246 / 255.0, 243 / 255.0 };
constexpr ChartColor ChartInk{ 0.13, 0.14, 0.16 };
constexpr ChartColor ChartQuietInk{ 0.42, 0.44, 0.47 };
/// Thin letters look paler than they are.
constexpr ChartColor ChartSmallInk{ 0.29, 0.30, 0.33 };
constexpr ChartColor ChartGrid{ 224 / 255.0, 222 / 255.0, 216 / 255.0 };

/// Corners one after the other around the middle; y runs up.
using MarkerOutline = std::vector<std::array<double, 2>>;

struct SeriesLook
{
  ChartColor Color;
  /// About as large as a circle of radius 1.
  MarkerOutline Marker;
};

/// Those of 8 series differ in colour and in marker, those of 64 in one of them.
SeriesLook LookOfSeries(std::size_t index);

/// How long a guide is drawn and left out by turns, in multiples of its width.
std::vector<double> DashesOfGuide(std::size_t index);

}

#endif
