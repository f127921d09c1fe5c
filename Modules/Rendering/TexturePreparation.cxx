#include "TexturePreparation.h"

#include "DrawnScene.h"
#include "PictureRequest.h"
#include "VolumeTextures.h"

#include "vtkIlluminatedVolumeMapper.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

namespace penumbra
{
namespace
{
std::string DescribeDimensions(const std::array<int, 3>& dimensions)
{
  return std::to_string(dimensions[0]) + " x " + std::to_string(dimensions[1]) + " x " +
    std::to_string(dimensions[2]);
}

vtkImageData* GetUsableMask(const PictureRequest& request, std::vector<std::string>& messages)
{
  vtkImageData* mask = request.Mapper->GetMaskInput();
  if (!mask)
  {
    return nullptr;
  }
  const int* maskDimensions = mask->GetDimensions();
  if (!mask->GetPointData()->GetScalars() ||
    !std::equal(maskDimensions, maskDimensions + 3, request.Image->GetDimensions()))
  {
    messages.emplace_back("The mask is left out: it needs scalars and the volume's dimensions.");
    return nullptr;
  }
  return mask;
}

CroppedRegions GetCroppedRegions(const DrawnScene& scene)
{
  CroppedRegions regions;
  regions.On = scene.Cropping == CroppingKind::Regions;
  if (regions.On)
  {
    regions.Flags = scene.CroppingFlags;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double voxels = scene.Placement.Dimensions[axis];
      regions.Low[axis] = scene.CroppingLow[axis] * voxels - 0.5;
      regions.High[axis] = scene.CroppingHigh[axis] * voxels - 0.5;
    }
  }
  return regions;
}
}

//------------------------------------------------------------------------------
std::string PrepareTextures(const PictureRequest& request, DrawnScene& scene,
  VolumeTextures& textures, std::vector<std::string>& messages)
{
  if (!textures.UpdateScalars(request.Window, request.Image, request.Scalars))
  {
    return "The graphics card cannot hold a volume of " +
      DescribeDimensions(scene.Placement.Dimensions) + " voxels.";
  }
  textures.SetInterpolation(request.Property->GetInterpolationType() != VTK_NEAREST_INTERPOLATION);
  if (textures.HasNonFiniteScalars())
  {
    messages.emplace_back(
      "Voxels that are NaN or -Inf count as the smallest finite value of the volume, +Inf as "
      "the largest.");
  }
  if (!textures.UpdateMask(request.Window, GetUsableMask(request, messages)))
  {
    return "The graphics card cannot hold the mask.";
  }
  textures.UpdateTransferFunctions(request.Window, request.Property,
    static_cast<GradientEstimator>(request.Mapper->GetGradientEstimator()));
  if (!textures.GetTransferFunctions().GetTable().Accurate)
  {
    messages.emplace_back(
      "The transfer functions change faster than the largest table can follow.");
  }
  scene.UnitDistance = request.Property->GetScalarOpacityUnitDistance(0);
  return {};
}

//------------------------------------------------------------------------------
bool PrepareEmptySpace(
  const PictureRequest& request, const DrawnScene& scene, VolumeTextures& textures)
{
  const bool leaping = request.Mapper->GetSkipEmptySpace();
  // Kept shadows lie around what is visible, whether rays leap or not.
  const bool keeping = request.Mapper->GetShadowTechnique() != vtkIlluminatedVolumeMapper::Rays;
  if (!leaping && !keeping)
  {
    textures.DropEmptySpace(request.Window);
    return false;
  }
  return textures.UpdateEmptySpace(request.Window, GetCroppedRegions(scene)) && leaping;
}

//------------------------------------------------------------------------------
int GetGradientTextureBits(const PictureRequest& request, const VolumeTextures& textures)
{
  const int bits = request.Mapper->GetGradientTextureBits();
  return bits == vtkIlluminatedVolumeMapper::AutomaticGradientTexture
    ? textures.ChooseGradientBits(
        static_cast<GradientEstimator>(request.Mapper->GetGradientEstimator()))
    : bits;
}

//------------------------------------------------------------------------------
void PrepareGradients(const PictureRequest& request, DrawnScene& scene, VolumeTextures& textures,
  std::vector<std::string>& messages)
{
  LightingRequirements& needs = scene.Requirements;
  const int bits = needs.GradientTexture ? GetGradientTextureBits(request, textures) : 0;
  if (!textures.UpdateGradients(request.Window, needs.Gradient, bits))
  {
    needs.GradientTexture = false;
    messages.emplace_back(
      "The graphics card cannot hold the gradients; they are estimated at each sample.");
  }
}

}
