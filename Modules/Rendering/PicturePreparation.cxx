#include "PicturePreparation.h"

#include "DrawnScene.h"
#include "GeometryPreparation.h"
#include "LightPreparation.h"
#include "MaterialPreparation.h"
#include "PictureRequest.h"
#include "ShadowPreparation.h"
#include "ShadowSettings.h"
#include "StepPreparation.h"
#include "TexturePreparation.h"
#include "VolumeDrawing.h"

namespace penumbra
{

//------------------------------------------------------------------------------
std::string PreparePicture(const PictureRequest& request, DrawnScene& scene,
  ShadowSettings& shadows, VolumeDrawing& drawing, std::vector<std::string>& messages)
{
  VolumeTextures& textures = drawing.GetTextures();
  std::string fault = PrepareGeometry(request, scene);
  if (fault.empty())
  {
    fault = PrepareTextures(request, scene, textures, messages);
  }
  if (!fault.empty())
  {
    return fault;
  }
  PrepareLights(request, scene, drawing, messages);
  PrepareMaterial(request, scene, textures);
  PrepareGradients(request, scene, textures, messages);
  shadows = DecideShadows(request, scene, textures);
  CoarsenMovingShadows(request, scene, shadows);
  PrepareShadows(shadows, request.Window, scene, drawing, messages);
  PrepareSteps(GetSampleDistances(request.Mapper), shadows.NearSteps, scene, textures, messages);
  LookUpShadows(shadows, scene);
  scene.Matter = DescribeShadowingMatter(scene, textures, request.Property);
  return {};
}

}
