#include "ImageComparison.h"

#include "StructuralSimilarity.h"

#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <stdexcept>

namespace penumbra
{
namespace
{
using Byte = unsigned char;

const Byte* Bytes(vtkImageData* picture)
{
  return static_cast<const Byte*>(picture->GetScalarPointer());
}

std::size_t NumberOfBytes(vtkImageData* picture)
{
  return static_cast<std::size_t>(picture->GetNumberOfPoints()) *
    picture->GetNumberOfScalarComponents();
}

std::string Description(vtkImageData* picture)
{
  const int* dimensions = picture->GetDimensions();
  return std::to_string(dimensions[0]) + "x" + std::to_string(dimensions[1]) + "x" +
    std::to_string(dimensions[2]) + " " + picture->GetScalarTypeAsString() + " of " +
    std::to_string(picture->GetNumberOfScalarComponents()) + " channels";
}

bool IsPicture(vtkImageData* picture)
{
  const int channels = picture->GetNumberOfScalarComponents();
  return picture->GetNumberOfPoints() > 0 && picture->GetDimensions()[2] == 1 &&
    picture->GetScalarType() == VTK_UNSIGNED_CHAR && (channels == 3 || channels == 4);
}

void CheckComparable(vtkImageData* picture, vtkImageData* baseline)
{
  if (!IsPicture(picture) || !IsPicture(baseline) || Description(picture) != Description(baseline))
  {
    throw std::invalid_argument(
      "cannot compare " + Description(picture) + " with " + Description(baseline));
  }
}

/// Luma of ITU-R BT.601, which the authors of the structural similarity use too.
GreyPicture Luminance(vtkImageData* picture)
{
  const int* dimensions = picture->GetDimensions();
  const int channels = picture->GetNumberOfScalarComponents();
  GreyPicture grey{ dimensions[0], dimensions[1], {} };
  const Byte* end = Bytes(picture) + NumberOfBytes(picture);
  for (const Byte* pixel = Bytes(picture); pixel != end; pixel += channels)
  {
    grey.levels.push_back(0.299 * pixel[0] + 0.587 * pixel[1] + 0.114 * pixel[2]);
  }
  return grey;
}

void ReportFailure(vtkImageData* picture, vtkImageData* baseline, const std::string& name,
  const BaselineFolders& folders)
{
  std::filesystem::create_directories(folders.failures);
  const std::string file = folders.failures + "/" + name + ".png";
  WritePNG(picture, file);
  std::cout << "  picture:    " << file << "\n";
  if (baseline)
  {
    const std::string differenceFile = folders.failures + "/" + name + "-difference.png";
    WritePNG(DifferenceImage(picture, baseline), differenceFile);
    std::cout << "  difference: " << differenceFile << "\n";
  }
}
}

ImageDifference CompareImages(vtkImageData* picture, vtkImageData* baseline)
{
  CheckComparable(picture, baseline);
  const Byte* a = Bytes(picture);
  const Byte* b = Bytes(baseline);
  const std::size_t count = NumberOfBytes(picture);
  double squares = 0.0;
  int largest = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const int difference = std::abs(a[i] - b[i]);
    squares += difference * difference;
    largest = std::max(largest, difference);
  }
  return { std::sqrt(squares / count), static_cast<double>(largest),
    StructuralSimilarity(Luminance(picture), Luminance(baseline)) };
}

vtkSmartPointer<vtkImageData> DifferenceImage(vtkImageData* picture, vtkImageData* baseline)
{
  const double largest = std::max(CompareImages(picture, baseline).largest, 1.0);
  auto difference = vtkSmartPointer<vtkImageData>::New();
  difference->SetDimensions(picture->GetDimensions());
  difference->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const int channels = picture->GetNumberOfScalarComponents();
  const Byte* a = Bytes(picture);
  const Byte* b = Bytes(baseline);
  auto* out = static_cast<Byte*>(difference->GetScalarPointer());
  for (vtkIdType pixel = 0; pixel < picture->GetNumberOfPoints(); ++pixel)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      const int distance = std::abs(a[channel] - b[channel]);
      *out++ = static_cast<Byte>(std::lround(distance * 255 / largest));
    }
    a += channels;
    b += channels;
  }
  return difference;
}

vtkSmartPointer<vtkImageData> ReadPNG(const std::string& file)
{
  vtkNew<vtkPNGReader> reader;
  if (!reader->CanReadFile(file.c_str()))
  {
    throw std::runtime_error("cannot read " + file + " as a PNG picture");
  }
  reader->SetFileName(file.c_str());
  reader->Update();
  if (reader->GetErrorCode() != 0)
  {
    throw std::runtime_error("cannot read all of " + file);
  }
  return reader->GetOutput();
}

void WritePNG(vtkImageData* picture, const std::string& file)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(picture);
  writer->Write();
  if (writer->GetErrorCode() != 0)
  {
    throw std::runtime_error("cannot write " + file);
  }
}

BaselineFolders BaselineFolders::OfProject()
{
  return { PENUMBRA_BASELINES, PENUMBRA_FAILURES };
}

bool CompareWithBaseline(vtkImageData* picture, const std::string& name,
  const ComparisonThresholds& thresholds, const BaselineFolders& folders)
{
  const std::string baselineFile = folders.baselines + "/" + name + ".png";
  if (!std::filesystem::exists(baselineFile))
  {
    std::cout << name << ": there is no baseline " << baselineFile << "\n";
    ReportFailure(picture, nullptr, name, folders);
    return false;
  }
  vtkSmartPointer<vtkImageData> baseline;
  ImageDifference difference;
  try
  {
    baseline = ReadPNG(baselineFile);
    difference = CompareImages(picture, baseline);
  }
  catch (const std::exception& error)
  {
    std::cout << name << ": " << error.what() << "\n";
    ReportFailure(picture, nullptr, name, folders);
    return false;
  }
  std::cout << name << ": RMSE " << difference.rmse << " (at most " << thresholds.maxRmse
            << "), structural similarity " << difference.ssim << " (at least " << thresholds.minSsim
            << "), largest difference " << difference.largest << "\n";
  const bool passed =
    difference.rmse <= thresholds.maxRmse && difference.ssim >= thresholds.minSsim;
  if (!passed)
  {
    ReportFailure(picture, baseline, name, folders);
  }
  return passed;
}
}
