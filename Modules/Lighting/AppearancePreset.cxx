#include "AppearancePreset.h"

#include "Document_cloud.h"
#include "Document_ct_abdomen.h"
#include "Document_ct_bone.h"
#include "Document_ct_lung.h"
#include "Document_ct_muscle.h"
#include "Document_ct_skin.h"
#include "Document_ct_skin_bone.h"
#include "Document_ct_vessels.h"
#include "Document_materials.h"
#include "Document_mr_angiography.h"
#include "Document_mr_brain.h"
#include "Document_mr_head.h"
#include "Document_surface.h"

namespace penumbra
{

const std::vector<AppearancePreset>& GetAppearancePresets()
{
  static const std::vector<AppearancePreset> presets{
    { "ct-bone", Document_ct_bone },
    { "ct-skin", Document_ct_skin },
    { "ct-skin-bone", Document_ct_skin_bone },
    { "ct-lung", Document_ct_lung },
    { "ct-vessels", Document_ct_vessels },
    { "ct-abdomen", Document_ct_abdomen },
    { "ct-muscle", Document_ct_muscle },
    { "mr-head", Document_mr_head },
    { "mr-brain", Document_mr_brain },
    { "mr-angiography", Document_mr_angiography },
    { "surface", Document_surface },
    { "cloud", Document_cloud },
  };
  return presets;
}

const std::string& GetNamedMaterials()
{
  static const std::string materials = Document_materials;
  return materials;
}

}
