#include "ShadowPreparation.h"

#include "DrawnScene.h"
#include "PictureRequest.h"
#include "ShadowSettings.h"
#include "VolumeDrawing.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace penumbra
{
namespace
{
ShadowVolumePlan PlanVolume(
  const ShadowSettings& settings, vtkOpenGLRenderWindow* window, const DrawnScene& scene)
{
  const VolumePlacement& placement = scene.Placement;
  ShadowVolumeTask task;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double voxels = placement.Dimensions[axis];
    task.Voxels[axis] = (placement.BoxHigh[axis] - placement.BoxLow[axis]) * voxels;
    Vector3 edge{};
    edge[axis] = 1.0 / voxels;
    task.VoxelEdges[axis] =
      GetLength(MultiplyDirection(placement.TextureToOwn, edge)) / placement.SmallestSpacing;
  }
  task.Resolution = settings.Resolution;
  task.Lights = static_cast<int>(scene.ShadowCasters.size());
  task.LargestSize = vtkTextureObject::GetMaximumTextureSize3D(window);
  task.LargestBytes = settings.GetLargestBytes();
  return PlanShadowVolume(task);
}

ShadowMapTask DescribeMaps(const ShadowSettings& settings, vtkOpenGLRenderWindow* window,
  const DrawnScene& scene, const VolumePlacement& matter)
{
  ShadowMapTask task;
  // The same wherever lights are, so that one that moves leaves the others' maps.
  task.Span = matter.GetDiagonal() / matter.SmallestSpacing;
  task.Resolution = settings.Resolution;
  task.Lights = static_cast<int>(scene.ShadowCasters.size());
  task.LargestSize = vtkTextureObject::GetMaximumTextureSize3D(window);
  task.LargestBytes = settings.GetLargestBytes();
  return task;
}

void MakeLightSpaces(const VolumePlacement& matter, DrawnScene& scene)
{
  const bool firstHits = scene.Requirements.Technique == ShadowTechnique::Map;
  for (ShadowCaster& caster : scene.ShadowCasters)
  {
    // A map is the same wherever samples' rays begin.
    caster.Begin = 0.0f;
    caster.FirstHit = firstHits && caster.Hard;
    scene.LightSpaces.push_back(ComputeLightSpace(matter, caster.Place));
  }
}

// Places for lights, and whether their texels are fewer than asked.
struct Room
{
  int Lights = 0;
  bool Coarsened = false;
  bool Made = true;
};

Room MakeRoom(const ShadowSettings& settings, vtkOpenGLRenderWindow* window, DrawnScene& scene,
  VolumeDrawing& drawing)
{
  scene.LightSpaces.clear();
  scene.VolumeOfShadows = {};
  scene.MapsOfShadows = {};
  scene.LayersOfShadows = {};
  Room room;
  if (!scene.ShadowCasters.empty())
  {
    scene.Requirements.Technique = settings.Technique;
    if (settings.Technique == ShadowTechnique::Volume)
    {
      scene.VolumeOfShadows = PlanVolume(settings, window, scene);
      room = { scene.VolumeOfShadows.Lights, scene.VolumeOfShadows.Coarsened };
    }
    else
    {
      // Only what is visible is shadowed, or casts a shadow.
      const VolumePlacement matter =
        drawing.GetTextures().GetEmptySpaceReport().DrawIn(scene.Placement);
      MakeLightSpaces(matter, scene);
      const ShadowMapTask task = DescribeMaps(settings, window, scene, matter);
      if (settings.Technique == ShadowTechnique::OpacityMap)
      {
        scene.LayersOfShadows = PlanOpacityMaps(task);
        drawing.GetLayersOfShadows().ShareTexture(scene.LayersOfShadows, task.LargestBytes);
        room = { scene.LayersOfShadows.Lights, scene.LayersOfShadows.Coarsened };
      }
      else
      {
        scene.MapsOfShadows = PlanShadowMaps(task);
        room = { scene.MapsOfShadows.Lights, scene.MapsOfShadows.Coarsened };
      }
    }
  }
  room.Made = drawing.GetVolumeOfShadows().Allocate(window, scene.VolumeOfShadows) &&
    drawing.GetMapsOfShadows().Allocate(window, scene.MapsOfShadows) &&
    drawing.GetLayersOfShadows().Allocate(window, scene.LayersOfShadows);
  return room;
}

bool HaveMoved(const std::vector<ShadowCaster>& before, const std::vector<ShadowCaster>& now)
{
  return before.size() == now.size() &&
    !std::equal(before.begin(), before.end(), now.begin(),
      [](const ShadowCaster& a, const ShadowCaster& b) { return a.Place == b.Place; });
}

void KeepNothing(vtkOpenGLRenderWindow* window, DrawnScene& scene, VolumeDrawing& drawing)
{
  scene.ShadowCasters.clear();
  scene.Requirements.Technique = ShadowTechnique::Rays;
  scene.Requirements.NearShadowRays = false;
  scene.Requirements.NearShadowSteps = 0;
  MakeRoom({}, window, scene, drawing);
}
}

//------------------------------------------------------------------------------
void CoarsenMovingShadows(
  const PictureRequest& request, DrawnScene& scene, ShadowSettings& settings)
{
  constexpr double coarser = 0.5;
  scene.ShadowsMove = request.Moving &&
    (scene.ShadowsMove ||
      HaveMoved(scene.ShadowCasters, scene.Lights.GetShadowCasters(scene.Requirements)));
  settings.Resolution *= scene.ShadowsMove ? coarser : 1.0;
}

//------------------------------------------------------------------------------
void PrepareShadows(const ShadowSettings& settings, vtkOpenGLRenderWindow* window,
  DrawnScene& scene, VolumeDrawing& drawing, std::vector<std::string>& messages)
{
  scene.ShadowCasters.clear();
  if (settings.Technique != ShadowTechnique::Rays)
  {
    scene.ShadowCasters = scene.Lights.GetShadowCasters(scene.Requirements);
  }
  const auto casters = static_cast<int>(scene.ShadowCasters.size());
  const Room room = MakeRoom(settings, window, scene, drawing);
  if (!room.Made)
  {
    messages.emplace_back("The graphics card cannot hold shadows; their rays are marched.");
  }
  if (!room.Made || room.Lights == 0)
  {
    KeepNothing(window, scene, drawing);
    return;
  }
  // As many in a row make a program that is not too long.
  constexpr int few = 8;
  const bool inARow = room.Lights == casters && settings.NearSteps <= few;
  scene.Requirements.NearShadowRays = !inARow;
  scene.Requirements.NearShadowSteps = inARow ? settings.NearSteps : 0;
  scene.ShadowCasters.resize(room.Lights);
  scene.LightSpaces.resize(std::min<std::size_t>(scene.LightSpaces.size(), room.Lights));
  if (room.Coarsened && !settings.Chosen)
  {
    messages.emplace_back(
      "Kept shadows are coarser than asked: they would take more memory than is allowed.");
  }
  if (room.Lights < casters)
  {
    messages.push_back("Shadows of " + std::to_string(room.Lights) +
      " lights are kept; those of the other " + std::to_string(casters - room.Lights) +
      " are marched.");
  }
  if (settings.Technique == ShadowTechnique::Map &&
    scene.Requirements.GetNumberOfLights(ShadowKind::Soft) > 0)
  {
    messages.emplace_back(
      "A map of first hits tells hard shadows only; soft ones are kept as deep maps.");
  }
}

//------------------------------------------------------------------------------
void LookUpShadows(const ShadowSettings& settings, DrawnScene& scene)
{
  if (scene.ShadowCasters.empty())
  {
    return;
  }
  const double marched = settings.NearSteps * scene.Plan.ShadowSampleDistance;
  if (scene.Requirements.Technique != ShadowTechnique::Volume)
  {
    scene.Lights.LookUpMaps(scene.Requirements, scene.LightSpaces, marched);
    if (scene.Requirements.Technique == ShadowTechnique::OpacityMap)
    {
      scene.Lights.LookUpLayers(scene.Requirements, scene.LightSpaces, scene.LayersOfShadows);
    }
    return;
  }
  scene.Lights.LookUpVolume(
    scene.Requirements, scene.VolumeOfShadows.Lights, scene.VolumeOfShadows.Blocks, marched);
  for (ShadowCaster& caster : scene.ShadowCasters)
  {
    caster.Begin += static_cast<float>(marched);
  }
}

}
