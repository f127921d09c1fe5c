/**
 * @file    LightForms.h
 * @brief   the controls of the selected light: a simple page and one with everything
 */

#ifndef LightForms_h
#define LightForms_h

namespace penumbra
{

class PropertyForm;
class SceneDocument;
class VolumeView;

/// Whether the document has a light that is selected.
bool HasSelectedLight(const SceneDocument* document);

void FillSimpleLightForm(PropertyForm* form, SceneDocument* document);
void FillAdvancedLightForm(PropertyForm* form, SceneDocument* document, VolumeView* view);

}

#endif
