/**
 * @file    Theme.h
 * @brief   light and dark colours of the window
 */

#ifndef Theme_h
#define Theme_h

namespace penumbra
{

enum class Theme
{
  /// Light or dark, as the system is.
  System,
  Light,
  Dark
};

/// Qt's own style that looks the same everywhere and follows the palette.
constexpr const char* StyleName = "Fusion";

/// This style in the colours of the theme.
void ApplyTheme(Theme theme = Theme::System);

}

#endif
