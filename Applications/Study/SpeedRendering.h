/**
 * @class   SpeedRendering
 * @brief   one way of drawing a cell of the speed study, in a window of its own
 */

#ifndef SpeedRendering_h
#define SpeedRendering_h

#include "Frames.h"
#include "SceneChange.h"
#include "SceneRendering.h"
#include "SpeedGrid.h"
#include "StudyPicture.h"
#include "vtkMessageCollector.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace penumbra
{

/// The scene as the cell and the request have it. @throw InputError where it does not take a
/// setting.
SceneDescription DescribeSpeedScene(
  const SpeedCell& cell, const SpeedRequest& request, const SceneVoxels& voxels);

class SpeedRendering
{
public:
  /// @throw RenderingError where there is no OpenGL.
  SpeedRendering(const SceneDescription& scene, const SceneVoxels& voxels);

  /// @throw RenderingError where VTK has an error to tell.
  ///@{
  FrameTime Draw();
  FrameTime DrawAfter(SceneChange change);
  ///@}

  /// What was drawn last.
  StudyPicture TakePicture() const;

  /// Draws a frame more, to count what its rays do, and reports it as penumbra-render does.
  /// @throw RenderingError where VTK has an error to tell.
  nlohmann::json Report();

  /// What the renderer does otherwise than asked.
  std::vector<std::string> GetWarnings() const;

private:
  vtkNew<vtkMessageCollector> Messages;
  SceneRendering Rendering;
  vtkSmartPointer<vtkImageData> Volume;
  vtkSmartPointer<vtkRenderWindow> Window;
  FrameDrawing Drawing;
};

}

#endif
