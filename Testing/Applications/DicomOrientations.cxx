#include "Catch.h"
#include "ImageComparison.h"
#include "LetteredPhantom.h"
#include "RunProgram.h"

#include <vtkImageData.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

using namespace penumbra;

namespace
{
constexpr int PictureSize = 96;

// Half of what the picture shows from top to bottom, in mm.
constexpr double HalfHeight = 13.0;

// Seen by who looks at the patient: along y, with the head up.
vtkSmartPointer<vtkImageData> PictureFromTheFront(
  const TemporaryFolder& folder, const std::string& name)
{
  const std::string scene = folder.Write(name + ".json",
    R"({
    "volume": { "file": ")" +
      name + R"(" },
    "transferFunction": { "opacity": [[100,0],[300,0.4],[1000,0.9]],
      "color": [[300,0.1,0.2,0.5],[1000,1,1,1]] },
    "lights": [ { "direction": [0.3,1,-0.4], "shadow": "soft" } ],
    "camera": { "position": [-19.5,-60,212.5], "focalPoint": [-19.5,22,212.5], "viewUp": [0,0,1],
      "parallelScale": 13 },
    "sampleDistance": 0.25,
    "image": { "size": [96,96] } })");
  const auto result = RunPenumbraRender({ scene, "--output", folder.PathOf(name + ".png") });
  INFO(result.error);
  REQUIRE(result.exitStatus == 0);
  return ReadPNG(folder.PathOf(name + ".png"));
}

int RedAt(vtkImageData* picture, int x, int y)
{
  return *static_cast<const unsigned char*>(picture->GetScalarPointer(x, y, 0));
}

int LargestDifference(vtkImageData* left, vtkImageData* right)
{
  const auto* a = static_cast<const unsigned char*>(left->GetScalarPointer());
  const auto* b = static_cast<const unsigned char*>(right->GetScalarPointer());
  int largest = 0;
  for (int index = 0; index < 3 * PictureSize * PictureSize; ++index)
  {
    largest = std::max(largest, std::abs(a[index] - b[index]));
  }
  return largest;
}

double RootMeanSquareDifference(vtkImageData* left, vtkImageData* right)
{
  const auto* a = static_cast<const unsigned char*>(left->GetScalarPointer());
  const auto* b = static_cast<const unsigned char*>(right->GetScalarPointer());
  double sum = 0.0;
  for (int index = 0; index < 3 * PictureSize * PictureSize; ++index)
  {
    sum += (a[index] - b[index]) * (a[index] - b[index]);
  }
  return std::sqrt(sum / (3 * PictureSize * PictureSize));
}

// A rounded body off the middle, denser towards the head and the patient's left, in 16 axial slices
// of 24 x 24 pixels, each `shear` mm further back than the one below.
DicomSlices TiltedBody(double shear)
{
  DicomSlices slices;
  for (int number = 0; number < 16; ++number)
  {
    auto slice = Slice(number);
    slice.columns = 24;
    slice.rows = 36;
    slice.elements["PixelSpacing"] = "1\\1";
    SetPosition(slice, { -31.0, 10.0 + shear * (number - 8), 205.0 + number });
    slice.stored = [slice](int i, int j, int)
    {
      const Vector place = Place(slice, i, j);
      const double x = (place[0] + 20.0) / 9.0;
      const double y = (place[1] - 27.0) / 8.0;
      const double z = (place[2] - 212.0) / 6.0;
      const double depth = 1.0 - x * x - y * y - z * z;
      return static_cast<long long>(
        std::max(0.0, 600.0 + 100.0 * x + 300.0 * z) * std::clamp(2.0 * depth, 0.0, 1.0));
    };
    slices.push_back(slice);
  }
  return slices;
}
}

TEST_CASE("However a scanner stores the patient, the picture is one")
{
  const std::pair<Vector, Vector> orientations[] = {
    { { 1, 0, 0 }, { 0, 1, 0 } },   // axial
    { { -1, 0, 0 }, { 0, -1, 0 } }, // axial, prone
    { { 0, 1, 0 }, { -1, 0, 0 } },  // axial, turned
    { { 1, 0, 0 }, { 0, 0, -1 } },  // coronal
    { { -1, 0, 0 }, { 0, 0, 1 } },  // coronal, head down
    { { 0, 1, 0 }, { 0, 0, -1 } },  // sagittal
    { { 0, -1, 0 }, { 0, 0, -1 } }, // sagittal, from the other side
    { { 0, 0, 1 }, { 0, 1, 0 } },   // sagittal, lying
  };
  const TemporaryFolder folder;
  vtkSmartPointer<vtkImageData> first;
  int number = 0;
  for (const auto& [row, column] : orientations)
  {
    const std::string name = "orientation " + std::to_string(number++);
    INFO(name);
    WriteSlices(folder, LetteredPhantom::Slices(row, column), name + "/");
    const auto picture = PictureFromTheFront(folder, name);
    first = first ? first : picture;
    // Samples of mirrored textures round differently in their last bit.
    CHECK(LargestDifference(first, picture) <= 1);
  }
}

TEST_CASE("The letters are readable from the front, the patient's left on the right")
{
  const TemporaryFolder folder;
  WriteSlices(folder, LetteredPhantom::Slices({ 0, 1, 0 }, { 0, 0, -1 }), "phantom/");
  const auto picture = PictureFromTheFront(folder, "phantom");
  for (const LetteredPhantom::Cell& cell : LetteredPhantom::Cells())
  {
    INFO(cell.x << " " << cell.z);
    const double pixelsPerMillimetre = PictureSize / (2.0 * HalfHeight);
    const double middle[2] = { (LetteredPhantom::Size[0] - 1) / 2.0,
      (LetteredPhantom::Size[2] - 1) / 2.0 };
    const int x = static_cast<int>(PictureSize / 2 + (cell.x - middle[0]) * pixelsPerMillimetre);
    const int y = static_cast<int>(PictureSize / 2 + (cell.z - middle[1]) * pixelsPerMillimetre);
    // The block is 18, its letters are 47 and more by how the light falls on their edges.
    CHECK((RedAt(picture, x, y) > 32) == cell.isLetter);
  }
}

TEST_CASE("A tilted gantry gives the picture of an upright one")
{
  const TemporaryFolder folder;
  WriteSlices(folder, TiltedBody(0.0), "upright/");
  WriteSlices(folder, TiltedBody(0.35), "tilted/");
  const auto upright = PictureFromTheFront(folder, "upright");
  const auto tilted = PictureFromTheFront(folder, "tilted");
  // The same body sampled at other points; without the shear it is more than 6.
  CHECK(RootMeanSquareDifference(upright, tilted) < 1.5);
}
