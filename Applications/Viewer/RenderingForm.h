/**
 * @file    RenderingForm.h
 * @brief   the controls of how the picture is made: steps, matter, clipping, background
 */

#ifndef RenderingForm_h
#define RenderingForm_h

namespace penumbra
{

class PropertyForm;
class SceneDocument;
class VolumeView;

void FillMaterialForm(PropertyForm* form, SceneDocument* document);
void FillRenderingForm(PropertyForm* form, SceneDocument* document, VolumeView* view);

}

#endif
