#include "DicomSlices.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <sstream>

const char* const SampleSeries = "1.2.3.4.100";

DicomSample UnplacedImage()
{
  static int count = 0;
  DicomSample image;
  image.elements = { { "SOPClassUID", "1.2.840.10008.5.1.4.1.1.2" },
    { "SOPInstanceUID", "1.2.3.4.5." + std::to_string(++count) }, { "Modality", "CT" },
    { "StudyInstanceUID", "1.2.3.4.99" }, { "SeriesInstanceUID", SampleSeries } };
  image.stored = [](int i, int j, int k) { return i + 10 * j + 100 * k; };
  return image;
}

DicomSample Slice(int number)
{
  auto slice = UnplacedImage();
  slice.elements["SeriesNumber"] = "7";
  slice.elements["InstanceNumber"] = std::to_string(number + 1);
  slice.elements["PixelSpacing"] = "0.5\\0.75";
  slice.elements["SliceThickness"] = "2";
  slice.elements["FrameOfReferenceUID"] = "1.2.3.4.98";
  SetOrientation(slice, { 1, 0, 0 }, { 0, 1, 0 });
  SetPosition(slice, { -10, 20, 30 + 2.5 * number });
  slice.stored = [number](int i, int j, int) { return i + 10 * j + 100 * number * number; };
  return slice;
}

DicomSlices Slices(int count)
{
  DicomSlices slices;
  for (int number = 0; number < count; ++number)
  {
    slices.push_back(Slice(number));
  }
  return slices;
}

void SetPosition(DicomSample& slice, const Vector& position)
{
  slice.elements["ImagePositionPatient"] = Text({ position[0], position[1], position[2] });
}

void SetOrientation(DicomSample& slice, const Vector& row, const Vector& column)
{
  slice.elements["ImageOrientationPatient"] =
    Text({ row[0], row[1], row[2], column[0], column[1], column[2] });
}

Vector Position(const DicomSample& slice)
{
  const auto numbers = Numbers(slice.elements.at("ImagePositionPatient"));
  return { numbers[0], numbers[1], numbers[2] };
}

Vector Normal(const DicomSample& slice)
{
  const auto o = Numbers(slice.elements.at("ImageOrientationPatient"));
  return { o[1] * o[5] - o[2] * o[4], o[2] * o[3] - o[0] * o[5], o[0] * o[4] - o[1] * o[3] };
}

Vector Place(const DicomSample& slice, int i, int j)
{
  const auto orientation = Numbers(slice.elements.at("ImageOrientationPatient"));
  const auto spacing = Numbers(slice.elements.at("PixelSpacing"));
  Vector place = Position(slice);
  for (int axis = 0; axis < 3; ++axis)
  {
    // PS3.3, equation C.7.6.2.1-1. Pixel Spacing begins with the distance between rows.
    place[axis] += orientation[axis] * spacing[1] * i + orientation[axis + 3] * spacing[0] * j;
  }
  return place;
}

double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double Stored(const DicomSample&, double stored)
{
  return stored;
}

namespace
{

std::string DifferenceAt(vtkImageData* volume, const DicomSample& slice, const ValueOf& valueOf,
  const std::array<int, 3>& voxel)
{
  const auto [i, j, k] = voxel;
  const Vector expected = Place(slice, i, j);
  Vector place;
  volume->TransformIndexToPhysicalPoint(i, j, k, place.data());
  const double value = volume->GetScalarComponentAsDouble(i, j, k, 0);
  const double expectedValue = valueOf(slice, slice.stored(i, j, 0));
  std::ostringstream difference;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(std::abs(place[axis] - expected[axis]) < 1e-4))
    {
      difference << place[axis] << " where " << expected[axis] << " is right, axis " << axis
                 << "; ";
    }
  }
  if (!(std::abs(value - expectedValue) <= 1e-6 * std::abs(expectedValue)))
  {
    difference << value << " where " << expectedValue << " is right";
  }
  if (!difference.str().empty())
  {
    difference << " at voxel " << i << ' ' << j << ' ' << k;
  }
  return difference.str();
}

std::string DifferentSize(vtkImageData* volume, const DicomSlices& slices)
{
  const int* const size = volume->GetDimensions();
  if (size[0] == slices[0].columns && size[1] == slices[0].rows &&
    size[2] == static_cast<int>(slices.size()))
  {
    return "";
  }
  std::ostringstream difference;
  difference << size[0] << " x " << size[1] << " x " << size[2] << " voxels";
  return difference.str();
}

}

std::string Difference(vtkImageData* volume, DicomSlices slices, const ValueOf& valueOf)
{
  const Vector normal = Normal(slices[0]);
  std::sort(slices.begin(), slices.end(),
    [&](const DicomSample& a, const DicomSample& b)
    { return Dot(Position(a), normal) < Dot(Position(b), normal); });
  auto difference = DifferentSize(volume, slices);
  for (int k = 0; k < static_cast<int>(slices.size()); ++k)
  {
    for (int j = 0; j < slices[k].rows && difference.empty(); ++j)
    {
      for (int i = 0; i < slices[k].columns && difference.empty(); ++i)
      {
        difference = DifferenceAt(volume, slices[k], valueOf, { i, j, k });
      }
    }
  }
  return difference;
}

void WriteSlices(const TemporaryFolder& folder, const DicomSlices& slices, const std::string& part)
{
  for (std::size_t number = 0; number < slices.size(); ++number)
  {
    folder.Write(part + std::to_string(number) + ".dcm", slices[number].File());
  }
}
