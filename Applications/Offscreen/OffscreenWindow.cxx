#include "OffscreenWindow.h"

#include "WindowKinds.h"

#include <array>
#include <cstdlib>
#include <stdexcept>
#include <utility>

namespace penumbra
{
namespace
{
constexpr std::array<std::pair<WindowKind, const char*>, 3> kindsByPreference = { {
  { WindowKind::OSMesa, "osmesa" },
  { WindowKind::EGL, "egl" },
  { WindowKind::Native, "native" },
} };

std::string AvailableKinds()
{
  std::string names;
  for (const auto& [kind, name] : kindsByPreference)
  {
    if (WhyUnavailable(kind).empty())
    {
      names += (names.empty() ? "" : ", ") + std::string(name);
    }
  }
  return names.empty() ? "none" : names;
}

WindowKind ForcedKind(const std::string& wanted)
{
  for (const auto& [kind, name] : kindsByPreference)
  {
    if (wanted != name)
    {
      continue;
    }
    const std::string reason = WhyUnavailable(kind);
    if (!reason.empty())
    {
      throw std::runtime_error("PENUMBRA_WINDOW=" + wanted + " cannot be used: " + reason +
        "; available here: " + AvailableKinds());
    }
    return kind;
  }
  throw std::runtime_error("PENUMBRA_WINDOW=" + wanted +
    " is unknown: it takes osmesa, egl or native; available here: " + AvailableKinds());
}

WindowKind PreferredKind()
{
  std::string reasons;
  for (const auto& [kind, name] : kindsByPreference)
  {
    const std::string reason = WhyUnavailable(kind);
    if (reason.empty())
    {
      return kind;
    }
    reasons += "; " + std::string(name) + ": " + reason;
  }
  throw std::runtime_error("no window to render to" + reasons);
}

WindowKind ChosenKind()
{
  static const WindowKind chosen = []
  {
    const char* wanted = std::getenv("PENUMBRA_WINDOW");
    return wanted && *wanted ? ForcedKind(wanted) : PreferredKind();
  }();
  return chosen;
}
}

void UseOffscreenWindows()
{
  static const bool installed = (InstallWindowKind(ChosenKind()), true);
  static_cast<void>(installed);
}

std::string OffscreenWindowKind()
{
  for (const auto& [kind, name] : kindsByPreference)
  {
    if (kind == ChosenKind())
    {
      return name;
    }
  }
  return {};
}
}
