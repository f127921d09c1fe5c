#include "Catch.h"
#include "NiftiSample.h"
#include "vtkMatrix4x4.h"
#include "vtkNIFTIImageWriter.h"
#include "vtkNew.h"

#include <cmath>

using Catch::Matchers::ContainsSubstring;

namespace
{

vtkSmartPointer<vtkImageData> ReadSample(const TemporaryFolder& folder, const NiftiSample& sample)
{
  const auto image = Read(folder.Write("a.nii", sample.File(SampleBytes<short>(sample.bigEndian))));
  CHECK(IsSample(image));
  return image;
}

// A qform that turns x to y and y to -x, and an sform that turns x to z, y to x and z to y.
NiftiSample PlacedSample(short qformCode, short sformCode)
{
  NiftiSample sample;
  sample.qformCode = qformCode;
  sample.sformCode = sformCode;
  sample.quaternion = { 0, 0, std::sqrt(0.5) };
  sample.qOffset = { 10, 20, 30 };
  sample.sform = { 0, 6, 0, -1, 0, 0, 7, -2, 5, 0, 0, -3 };
  return sample;
}

}

TEST_CASE("NIfTI is placed by the sform, else the qform, else pixdim")
{
  const TemporaryFolder folder;
  for (const int version : { 1, 2 })
  {
    INFO("NIfTI-" << version);
    for (const short qformCode : { 0, 1 })
    {
      auto sample = PlacedSample(qformCode, 2);
      sample.version = version;
      CHECK(IsPlaced(
        ReadSample(folder, sample), { -1, -2, -3 }, { { { 0, 0, 5 }, { 6, 0, 0 }, { 0, 7, 0 } } }));
    }
    auto sample = PlacedSample(1, 0);
    sample.version = version;
    CHECK(IsPlaced(
      ReadSample(folder, sample), { 10, 20, 30 }, { { { 0, 2, 0 }, { -3, 0, 0 }, { 0, 0, 4 } } }));
    sample.qformCode = 0;
    CHECK(IsPlaced(
      ReadSample(folder, sample), { 0, 0, 0 }, { { { 2, 0, 0 }, { 0, 3, 0 }, { 0, 0, 4 } } }));
  }
}

TEST_CASE("A NIfTI qform with the factor -1 mirrors the slices' axis")
{
  const TemporaryFolder folder;
  auto sample = PlacedSample(1, 0);
  sample.pixdim[0] = -1;
  CHECK(IsPlaced(
    ReadSample(folder, sample), { 10, 20, 30 }, { { { 0, 2, 0 }, { -3, 0, 0 }, { 0, 0, -4 } } }));
}

TEST_CASE("A NIfTI sform may mirror, but not shear")
{
  const TemporaryFolder folder;
  auto sample = PlacedSample(0, 1);
  sample.sform = { -1, 0, 0, 90, 0, 1, 0, -126, 0, 0, 1, -72 };
  CHECK(IsPlaced(
    ReadSample(folder, sample), { 90, -126, -72 }, { { { -1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } }));
  const auto failure = [&]
  { return FailureOf(folder.Write("b.nii", sample.File(SampleBytes<short>()))); };
  sample.sform[1] = 0.1;
  CHECK_THAT(failure(), ContainsSubstring("sheared"));
  sample.sform = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0 };
  CHECK_THAT(failure(), ContainsSubstring("axis 3"));
  sample.sform = { 1, 0, 0, std::nan(""), 0, 1, 0, 0, 0, 0, 1, 0 };
  CHECK_THAT(failure(), ContainsSubstring("origin"));
  sample = PlacedSample(1, 0);
  sample.quaternion[0] = std::nan("");
  CHECK_THAT(failure(), ContainsSubstring("axis 1"));
}

TEST_CASE("An oblique qform of single precision gives a rotation")
{
  const TemporaryFolder folder;
  auto sample = PlacedSample(1, 0);
  // Half a turn about an axis; the three numbers, rounded, are a little longer than 1.
  const double length = 1.0 + 1e-7;
  sample.quaternion = { 0.6 * length, 0.8 * length, 0.0 };
  CHECK(IsPlaced(ReadSample(folder, sample), { 10, 20, 30 },
    { { { -0.28 * 2, 0.96 * 2, 0 }, { 0.96 * 3, 0.28 * 3, 0 }, { 0, 0, -4 } } }, 1e-5));
}

TEST_CASE("What VTK writes as NIfTI is read")
{
  const TemporaryFolder folder;
  const auto image = ReadSample(folder, NiftiSample());
  vtkNew<vtkMatrix4x4> matrix;
  const double elements[16] = { 0, -1, 0, 10, 1, 0, 0, 20, 0, 0, 1, 30, 0, 0, 0, 1 };
  matrix->DeepCopy(elements);
  for (const char* name : { "b.nii", "b.nii.gz" })
  {
    vtkNew<vtkNIFTIImageWriter> writer;
    writer->SetInputData(image);
    writer->SetQFormMatrix(matrix);
    writer->SetFileName(folder.PathOf(name).c_str());
    writer->Write();
    const auto written = Read(folder.PathOf(name));
    CHECK(IsSample(written));
    CHECK(IsPlaced(written, { 10, 20, 30 }, { { { 0, 2, 0 }, { -3, 0, 0 }, { 0, 0, 4 } } }, 1e-5));
  }
}
