#include "SpeedVoxels.h"

#include "SceneFile.h"

#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkImageFlip.h>
#include <vtkImageResize.h>
#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
// The volume keeps its bounds: its first and last voxels along each axis stay where they are.
vtkSmartPointer<vtkImageData> Resample(vtkImageData* volume, int edge)
{
  const int* size = volume->GetDimensions();
  const int longest = *std::max_element(size, size + 3);
  if (edge == longest || longest == 1)
  {
    return volume;
  }
  int resampled[3];
  std::transform(size, size + 3, resampled,
    [&](int count)
    { return static_cast<int>(std::lround((count - 1.0) * (edge - 1.0) / (longest - 1.0))) + 1; });
  vtkNew<vtkImageResize> resize;
  resize->SetInputData(volume);
  resize->SetResizeMethodToOutputDimensions();
  resize->SetOutputDimensions(resampled);
  resize->Update();
  vtkImageData* output = resize->GetOutput();
  // What the filter drops: how the volume lies, and its modality, by which a look is chosen.
  output->SetDirectionMatrix(volume->GetDirectionMatrix());
  output->SetFieldData(volume->GetFieldData());
  return output;
}

bool IsMirrored(const VolumeDescription& description, vtkImageData* volume)
{
  const double inWorld = vtkMatrix4x4::Determinant(description.Transform.data());
  return inWorld * volume->GetDirectionMatrix()->Determinant() < 0.0;
}

// The same volume with its voxels in reversed order along x.
vtkSmartPointer<vtkImageData> ReverseRows(vtkImageData* volume)
{
  vtkNew<vtkImageFlip> flip;
  flip->SetInputData(volume);
  flip->SetFilteredAxis(0);
  flip->Update();
  vtkImageData* output = flip->GetOutput();
  double first[3];
  volume->TransformIndexToPhysicalPoint(volume->GetDimensions()[0] - 1, 0, 0, first);
  vtkNew<vtkMatrix3x3> direction;
  direction->DeepCopy(volume->GetDirectionMatrix());
  for (int row = 0; row < 3; ++row)
  {
    direction->SetElement(row, 0, -direction->GetElement(row, 0));
  }
  output->SetOrigin(first);
  output->SetDirectionMatrix(direction);
  output->SetFieldData(volume->GetFieldData());
  return output;
}
}

//------------------------------------------------------------------------------
SceneVoxels ReadSpeedVoxels(const SpeedCell& cell, const std::filesystem::path& dicomParser)
{
  const SceneDescription scene = LoadScene(cell.Scene.File, {});
  std::vector<std::string> warnings;
  SceneVoxels voxels = ReadVoxels(scene.Volume, { dicomParser, {} }, warnings);
  voxels.Environment = ReadEnvironmentImages(scene.Material);
  if (cell.Edge > 0)
  {
    voxels.Volume = Resample(voxels.Volume, cell.Edge);
    // A mask says which voxels are hidden, of which there are others now.
    voxels.Mask = nullptr;
  }
  // The stock mapper draws nothing of what is mirrored. Cropping and masks follow the voxels.
  if (IsMirrored(scene.Volume, voxels.Volume) && !scene.Volume.Cropping && !voxels.Mask)
  {
    voxels.Volume = ReverseRows(voxels.Volume);
  }
  return voxels;
}

}
