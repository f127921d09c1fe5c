#include "ShaderSource.h"

#include "AccumulationNone.h"
#include "AccumulationPrevious.h"
#include "AttenuationDistance.h"
#include "AttenuationNone.h"
#include "BoxInterval.h"
#include "BoxVertex.h"
#include "ClippingNone.h"
#include "ClippingPlanes.h"
#include "CompositeAccumulation.h"
#include "CroppingBox.h"
#include "CroppingRegions.h"
#include "Declarations.h"
#include "DiffuseNone.h"
#include "DiffuseTerm.h"
#include "GradientCentral.h"
#include "GradientOpacityNone.h"
#include "GradientOpacityTable.h"
#include "LightFalloff.h"
#include "LightPoint.h"
#include "Lights.h"
#include "LightsDirectional.h"
#include "LightsPoint.h"
#include "LightsSpot.h"
#include "MaskBinary.h"
#include "MaskNone.h"
#include "OpacityPoints.h"
#include "OpacityTable.h"
#include "ReflectionPhong.h"
#include "SegmentDepth.h"
#include "ShadingAmbient.h"
#include "ShadingLights.h"
#include "ShadingNone.h"
#include "ShadowHardRay.h"
#include "ShadowRay.h"
#include "ShadowSoftRay.h"
#include "SidesOne.h"
#include "SidesTwo.h"
#include "SpecularNone.h"
#include "SpecularTerm.h"
#include "Transmittance.h"
#include "ViewRay.h"

#include <array>

namespace penumbra
{
namespace
{
using Needs = LightingRequirements;

struct Snippet
{
  const char* Source;
  bool (*Needed)(const Needs& needs, bool continued);
};

bool Always(const Needs&, bool)
{
  return true;
}

bool IsPositional(const Needs& needs)
{
  return needs.GetNumberOfLights(LightKind::Point) + needs.GetNumberOfLights(LightKind::Spot) > 0;
}

bool Shadowed(const Needs& needs)
{
  return needs.GetNumberOfShadowedLights() > 0;
}

// In GLSL order: what is used stands before its use. Alternatives stand together, and exactly one of
// them is needed.
const Snippet FragmentSnippets[] = {
  { Declarations, Always },
  { BoxInterval, Always },
  { Transmittance, Always },
  { OpacityTable, [](const Needs& n, bool) { return n.Opacity == TransferFunctionLookup::Table; } },
  { OpacityPoints, [](const Needs& n, bool) { return n.Opacity == TransferFunctionLookup::Points; } },
  { ClippingNone, [](const Needs& n, bool) { return n.ClippingPlanes == 0; } },
  { ClippingPlanes, [](const Needs& n, bool) { return n.ClippingPlanes > 0; } },
  { CroppingBox, [](const Needs& n, bool) { return n.Cropping != CroppingKind::Regions; } },
  { CroppingRegions, [](const Needs& n, bool) { return n.Cropping == CroppingKind::Regions; } },
  { MaskNone, [](const Needs& n, bool) { return !n.Mask; } },
  { MaskBinary, [](const Needs& n, bool) { return n.Mask; } },
  { GradientCentral, [](const Needs& n, bool) { return n.NeedsGradient(); } },
  { GradientOpacityNone, [](const Needs& n, bool) { return !n.GradientOpacity; } },
  { GradientOpacityTable, [](const Needs& n, bool) { return n.GradientOpacity; } },
  { SegmentDepth, Always },
  { ReflectionPhong, [](const Needs& n, bool) { return n.NeedsNormal(); } },
  { SidesOne, [](const Needs& n, bool) { return n.NeedsNormal() && !n.TwoSidedLighting; } },
  { SidesTwo, [](const Needs& n, bool) { return n.NeedsNormal() && n.TwoSidedLighting; } },
  { DiffuseNone, [](const Needs& n, bool) { return n.NeedsNormal() && !n.Diffuse; } },
  { DiffuseTerm, [](const Needs& n, bool) { return n.NeedsNormal() && n.Diffuse; } },
  { SpecularNone, [](const Needs& n, bool) { return n.NeedsNormal() && !n.Specular; } },
  { SpecularTerm, [](const Needs& n, bool) { return n.NeedsNormal() && n.Specular; } },
  { Lights, [](const Needs& n, bool) { return n.NeedsNormal(); } },
  { ShadowRay, [](const Needs& n, bool) { return Shadowed(n); } },
  { ShadowSoftRay, [](const Needs& n, bool) { return n.GetNumberOfLights(ShadowKind::Soft) > 0; } },
  { ShadowHardRay, [](const Needs& n, bool) { return n.GetNumberOfLights(ShadowKind::Hard) > 0; } },
  { LightsDirectional,
    [](const Needs& n, bool) { return n.GetNumberOfLights(LightKind::Directional) > 0; } },
  { LightFalloff, [](const Needs& n, bool) { return IsPositional(n); } },
  { AttenuationNone, [](const Needs& n, bool) { return IsPositional(n) && !n.Attenuation; } },
  { AttenuationDistance, [](const Needs& n, bool) { return IsPositional(n) && n.Attenuation; } },
  { LightPoint, [](const Needs& n, bool) { return IsPositional(n); } },
  { LightsPoint, [](const Needs& n, bool) { return n.GetNumberOfLights(LightKind::Point) > 0; } },
  { LightsSpot, [](const Needs& n, bool) { return n.GetNumberOfLights(LightKind::Spot) > 0; } },
  { ShadingNone, [](const Needs& n, bool) { return !n.Shade; } },
  { ShadingAmbient, [](const Needs& n, bool) { return n.Shade && !n.NeedsNormal(); } },
  { ShadingLights, [](const Needs& n, bool) { return n.NeedsNormal(); } },
  { AccumulationNone, [](const Needs&, bool continued) { return !continued; } },
  { AccumulationPrevious, [](const Needs&, bool continued) { return continued; } },
  { ViewRay, Always },
};

std::string Define(const std::string& name, int value)
{
  return "#define " + name + " " + std::to_string(value) + "\n";
}

// How many lights of each kind and shadow state there are and where each group begins.
std::string DefineLightGroups(const Needs& needs)
{
  const std::array<std::string, NumberOfLightKinds> kinds = { "DIRECTIONAL", "POINT", "SPOT" };
  std::string text = Define("LIGHTS", needs.GetNumberOfLights());
  int first = 0;
  for (int kind = 0; kind < NumberOfLightKinds; ++kind)
  {
    const auto& counts = needs.Lights[kind];
    const std::string& name = kinds[kind];
    const int unshadowed = counts[static_cast<int>(ShadowKind::None)];
    const int soft = counts[static_cast<int>(ShadowKind::Soft)];
    const int hard = counts[static_cast<int>(ShadowKind::Hard)];
    text += Define(name + "_LIGHTS", unshadowed + soft + hard);
    text += Define(name + "_UNSHADOWED", unshadowed);
    text += Define(name + "_SOFT", soft);
    text += Define(name + "_HARD", hard);
    text += Define(name + "_FIRST", first);
    text += Define(name + "_SOFT_FIRST", first + unshadowed);
    text += Define(name + "_HARD_FIRST", first + unshadowed + soft);
    first += unshadowed + soft + hard;
  }
  return text;
}
}

//------------------------------------------------------------------------------
std::string GetVertexShaderSource()
{
  return BoxVertex;
}

//------------------------------------------------------------------------------
std::string GetFragmentShaderSource(const LightingRequirements& requirements, bool continued)
{
  std::string source = "//VTK::System::Dec\n//VTK::Output::Dec\n\n";
  source += DefineLightGroups(requirements);
  source += Define("CLIPPING_PLANES", requirements.ClippingPlanes);
  for (const Snippet& snippet : FragmentSnippets)
  {
    if (snippet.Needed(requirements, continued))
    {
      source += "\n";
      source += snippet.Source;
    }
  }
  return source;
}

//------------------------------------------------------------------------------
std::string GetCompositeShaderSource()
{
  return CompositeAccumulation;
}

}
