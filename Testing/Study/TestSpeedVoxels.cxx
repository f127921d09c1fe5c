#include "Catch.h"
#include "SceneFile.h"
#include "SpeedVoxels.h"
#include "TemporaryFolder.h"
#include "VolumeBox.h"

#include <vtkImageData.h>
#include <vtkMatrix3x3.h>

using namespace penumbra;

TEST_CASE("A volume in another size fills the same box")
{
  const SpeedCell own{ { "brain", PENUMBRA_DATA "/brain.json" } };
  SpeedCell other = own;
  other.Edge = 40;
  const SceneVoxels voxels = ReadSpeedVoxels(own, {});
  const SceneVoxels resampled = ReadSpeedVoxels(other, {});
  const int* size = resampled.Volume->GetDimensions();
  CHECK(std::vector<int>(size, size + 3) == std::vector<int>{ 40, 40, 26 });
  const auto transform = SceneDescription().Volume.Transform;
  const auto corners = VolumeBox(voxels.Volume, transform).GetCorners();
  const auto resampledCorners = VolumeBox(resampled.Volume, transform).GetCorners();
  for (std::size_t corner = 0; corner < corners.size(); ++corner)
  {
    CHECK(Length(Difference(corners[corner], resampledCorners[corner])) < 1e-9);
  }
}

TEST_CASE("A mirrored volume lies where it was, without the mirror")
{
  const TemporaryFolder folder;
  WriteAnalyticScene("tree", 9, folder.PathOf(""));
  const std::string file = folder.Write("mirrored.json",
    R"({ "volume": { "file": "tree.vti", "transform": [1,0,0,0, 0,-1,0,5, 0,0,1,0, 0,0,0,1] } })");
  std::vector<std::string> warnings;
  const SceneVoxels mirrored = ReadVoxels(LoadScene(file, {}).Volume, {}, warnings);
  const SceneVoxels turned = ReadSpeedVoxels({ { "mirrored", file } }, {});
  CHECK(turned.Volume->GetDirectionMatrix()->Determinant() == -1.0);
  for (int i = 0; i < 9; ++i)
  {
    double before[3];
    double after[3];
    mirrored.Volume->TransformIndexToPhysicalPoint(i, 4, 1, before);
    turned.Volume->TransformIndexToPhysicalPoint(8 - i, 4, 1, after);
    CHECK(Length({ before[0] - after[0], before[1] - after[1], before[2] - after[2] }) < 1e-9);
    CHECK(mirrored.Volume->GetScalarComponentAsDouble(i, 4, 1, 0) ==
      turned.Volume->GetScalarComponentAsDouble(8 - i, 4, 1, 0));
  }
}
