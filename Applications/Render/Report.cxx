#include "Report.h"

#include "PictureBrightness.h"
#include "Process.h"
#include "ScalarTypes.h"

#include <vtkDataArray.h>
#include <vtkIlluminatedVolumeMapper.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>
#include <vtkVersion.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace penumbra
{
namespace
{
using Json = nlohmann::ordered_json;

// Null where there are none.
Json Median(std::vector<double> values)
{
  if (values.empty())
  {
    return nullptr;
  }
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

Json DescribeVolume(vtkImageData* volume)
{
  const int* dimensions = volume->GetDimensions();
  const double* spacing = volume->GetSpacing();
  const double* origin = volume->GetOrigin();
  const double* direction = volume->GetDirectionMatrix()->GetData();
  double range[2];
  volume->GetPointData()->GetScalars()->GetFiniteRange(range, 0);
  return { { "dims", { dimensions[0], dimensions[1], dimensions[2] } },
    { "spacing", { spacing[0], spacing[1], spacing[2] } },
    { "origin", { origin[0], origin[1], origin[2] } },
    { "direction", std::vector<double>(direction, direction + 9) },
    { "scalarType", ScalarTypeName(volume->GetScalarType()) },
    { "range", { range[0], range[1] } } };
}

Json DescribeBrightness(vtkImageData* picture)
{
  const PictureBrightness brightness = MeasureBrightness(picture);
  return { { "foreground", brightness.Foreground }, { "luminance", brightness.Luminance },
    { "burntOut", brightness.BurntOut }, { "black", brightness.Black } };
}

// Null where gradients are not kept.
Json DescribeGradientTexture(vtkIlluminatedVolumeMapper* mapper)
{
  if (!mapper || mapper->GetGradientTextureBytes() == 0)
  {
    return nullptr;
  }
  return { { "bits", mapper->GetActualGradientTextureBits() },
    { "bytes", mapper->GetGradientTextureBytes() },
    { "largestError", mapper->GetGradientTextureLargestError() },
    { "meanAngularError", mapper->GetGradientTextureAngularError() } };
}

// Null where rays do not look for it.
Json DescribeEmptySpace(vtkIlluminatedVolumeMapper* mapper)
{
  if (!mapper || mapper->GetNumberOfBricks() == 0)
  {
    return nullptr;
  }
  return { { "bricks", mapper->GetNumberOfBricks() },
    { "occupiedBricks", mapper->GetNumberOfOccupiedBricks() },
    { "brickEdge", mapper->GetBrickEdge() }, { "meanVoxelDepth", mapper->GetMeanVoxelDepth() } };
}

// Null where rays are marched, which keep nothing between frames.
Json DescribeKeptShadows(vtkIlluminatedVolumeMapper* mapper)
{
  if (!mapper || mapper->GetShadowBytes() == 0)
  {
    return nullptr;
  }
  return { { "bytes", mapper->GetShadowBytes() },
    { "resolution", mapper->GetActualShadowResolution() },
    { "nearSteps", mapper->GetActualShadowNearSteps() },
    { "lightsComputed", mapper->GetNumberOfShadowUpdates() } };
}

// Null where they are not counted.
Json DescribeRayCounts(vtkIlluminatedVolumeMapper* mapper)
{
  if (!mapper || !mapper->GetRayCounting())
  {
    return nullptr;
  }
  return { { "samples", mapper->GetNumberOfSamples() },
    { "shadedSamples", mapper->GetNumberOfShadedSamples() },
    { "shadowSteps", mapper->GetNumberOfShadowSteps() } };
}

// Null where it did not render.
Json DescribeReference(const std::optional<ReferenceStatistics>& statistics)
{
  if (!statistics)
  {
    return nullptr;
  }
  return { { "largestError", statistics->LargestError },
    { "rootMeanSquareError", statistics->RootMeanSquareError },
    { "pixelsNotConverged", statistics->PixelsNotConverged }, { "samples", statistics->Samples },
    { "shadowRays", statistics->ShadowRays } };
}

std::string NameOfTechnique(vtkIlluminatedVolumeMapper* mapper)
{
  const bool shadowed = mapper && mapper->GetRequirements().GetNumberOfShadowedLights() > 0;
  return shadowed ? GetName(mapper->GetRequirements().Technique) : "none";
}

std::vector<RequirementEntry> EntriesOf(vtkIlluminatedVolumeMapper* mapper)
{
  return mapper ? mapper->GetRequirements().GetEntries() : std::vector<RequirementEntry>();
}
}

//------------------------------------------------------------------------------
std::string WriteReport(const RenderedFrames& frames, vtkImageData* volume,
  vtkIlluminatedVolumeMapper* mapper, const ReportTexts& texts)
{
  std::vector<double> seconds;
  std::vector<double> cpuSeconds;
  for (const FrameTime& time : frames.Others)
  {
    seconds.push_back(time.Seconds);
    cpuSeconds.push_back(time.CpuSeconds);
  }
  Json requirements = Json::object();
  for (const RequirementEntry& entry : EntriesOf(mapper))
  {
    requirements[entry.Name] = entry.Value;
  }
  Json report;
  report["vtkVersion"] = vtkVersion::GetVTKVersion();
  report["openglRenderer"] = frames.OpenGLRenderer;
  report["volume"] = DescribeVolume(volume);
  report["firstFrameSeconds"] = frames.First.Seconds;
  report["frameSeconds"] = seconds;
  report["frameCpuSeconds"] = cpuSeconds;
  report["medianFrameSeconds"] = Median(seconds);
  report["shadowUpdateSeconds"] = mapper ? mapper->GetShadowUpdateSeconds() : 0.0;
  report["brightness"] = DescribeBrightness(frames.Picture);
  report["reference"] = DescribeReference(frames.Reference);
  report["technique"] = NameOfTechnique(mapper);
  report["techniqueReason"] = mapper ? mapper->GetShadowTechniqueReason() : "";
  report["keptShadows"] = DescribeKeptShadows(mapper);
  report["requirements"] = requirements;
  report["emptySpace"] = DescribeEmptySpace(mapper);
  report["gradientTexture"] = DescribeGradientTexture(mapper);
  report["rayCounts"] = DescribeRayCounts(mapper);
  report["leftOut"] = mapper ? mapper->GetRequirements().GetLeftOut() : std::vector<std::string>();
  report["choices"] = texts.Choices;
  report["warnings"] = texts.Warnings;
  report["peakMemoryBytes"] = PeakMemoryBytes();
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

//------------------------------------------------------------------------------
std::string ExplainRequirements(vtkIlluminatedVolumeMapper* mapper)
{
  if (!mapper)
  {
    return "The stock mapper renders this scene; it tells nothing of what it needs.\n";
  }
  constexpr int column = 28;
  std::ostringstream needed;
  std::ostringstream leftOut;
  for (const RequirementEntry& entry : EntriesOf(mapper))
  {
    if (entry.Needed)
    {
      needed << "  " << std::left << std::setw(column) << entry.Name << entry.Value << "\n";
    }
    else
    {
      leftOut << "  " << entry.Name << "\n";
    }
  }
  const std::string shadows =
    "Shadows by " + NameOfTechnique(mapper) + ": " + mapper->GetShadowTechniqueReason() + "\n";
  return "This scene needs\n" + needed.str() + "and leaves out\n" + leftOut.str() + shadows;
}

}
