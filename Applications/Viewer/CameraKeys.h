/**
 * @file    CameraKeys.h
 * @brief   what keys do to the camera
 */

#ifndef CameraKeys_h
#define CameraKeys_h

class vtkCamera;

namespace penumbra
{

/// Turns by the arrow keys, zooms by plus and minus. Returns whether the key (Qt::Key) is one of
/// these.
bool MoveByKey(int key, vtkCamera* camera);

}

#endif
