/**
 * @file    ClippingForm.h
 * @brief   the controls of what is cut away: a box, and planes
 */

#ifndef ClippingForm_h
#define ClippingForm_h

class QAction;

namespace penumbra
{

class PropertyForm;
class SceneDocument;
class VolumeView;

/// `drag` shows the box and the planes in the view; it is set where something new can be dragged.
void FillClippingForm(PropertyForm* form, SceneDocument* document, VolumeView* view, QAction* drag);

}

#endif
