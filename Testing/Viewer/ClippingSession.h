/**
 * @file    ClippingSession.h
 * @brief   a viewer on shells that are to be clipped
 */

#ifndef ClippingSession_h
#define ClippingSession_h

#include "NumberBox.h"
#include "ViewerSession.h"

#include <QAbstractButton>

namespace penumbra
{

/// What a cut that is seen changes at least.
constexpr double Seen = 2.0;
/// Voxels that what is dragged may stay behind: motion counts as seen along the axis, which is
/// oblique to the view.
constexpr double Behind = 3.0;

struct ClippingSession : ViewerSession
{
  ClippingSession() { REQUIRE(this->Open(this->Files.File)); }

  const SceneDescription& Scene() { return this->Document.GetScene(); }
  void Click(const char* name) { this->Find<QAbstractButton>(name)->click(); }
  void Enter(const char* name, double number) { this->Find<NumberBox>(name)->setValue(number); }
};

}

#endif
