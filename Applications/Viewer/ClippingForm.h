/**
 * @file    ClippingForm.h
 * @brief   the controls of what is cut away: a box, and a plane
 */

#ifndef ClippingForm_h
#define ClippingForm_h

namespace penumbra
{

class PropertyForm;
class SceneDocument;
class VolumeView;

void FillClippingForm(PropertyForm* form, SceneDocument* document, VolumeView* view);

}

#endif
