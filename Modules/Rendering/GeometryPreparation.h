/**
 * @file    GeometryPreparation.h
 * @brief   where a picture's volume is, what cuts it, and the view rays through it
 */

#ifndef GeometryPreparation_h
#define GeometryPreparation_h

#include <string>

namespace penumbra
{

struct DrawnScene;
struct PictureRequest;

/// Empty, or why the volume cannot be drawn: one sentence.
std::string PrepareGeometry(const PictureRequest& request, DrawnScene& scene);

}

#endif
