#include "StudyPicture.h"

#include "StructuralSimilarity.h"

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMetaImageReader.h>
#include <vtkMetaImageWriter.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace penumbra
{
namespace
{
constexpr int Channels = 4;

GreyPicture LuminanceOf(const StudyPicture& picture)
{
  GreyPicture grey{ picture.Width, picture.Height, {} };
  for (std::size_t at = 0; at < picture.Values.size(); at += Channels)
  {
    const float* value = &picture.Values[at];
    grey.levels.push_back(255.0 * (0.2126 * value[0] + 0.7152 * value[1] + 0.0722 * value[2]));
  }
  return grey;
}

void RefuseOtherSize(const StudyPicture& picture, const StudyPicture& other)
{
  if (picture.Width != other.Width || picture.Height != other.Height)
  {
    throw std::invalid_argument("the pictures are of different sizes");
  }
}

std::vector<double> DifferencesOf(const StudyPicture& left, const StudyPicture& right)
{
  std::vector<double> differences;
  for (std::size_t at = 0; at < left.Values.size(); ++at)
  {
    if (at % Channels != Channels - 1)
    {
      differences.push_back(
        255.0 * std::abs(static_cast<double>(left.Values[at]) - right.Values[at]));
    }
  }
  return differences;
}
}

//------------------------------------------------------------------------------
StudyPicture ToStudyPicture(vtkImageData* picture)
{
  const int* size = picture->GetDimensions();
  const auto* levels = static_cast<const unsigned char*>(picture->GetScalarPointer());
  StudyPicture converted{ size[0], size[1], {} };
  converted.Values.resize(static_cast<std::size_t>(Channels) * size[0] * size[1]);
  std::transform(levels, levels + converted.Values.size(), converted.Values.begin(),
    [](unsigned char level) { return level / 255.0f; });
  return converted;
}

//------------------------------------------------------------------------------
StudyPicture ReadStudyPicture(const std::filesystem::path& file)
{
  vtkNew<vtkMetaImageReader> reader;
  reader->SetFileName(file.u8string().c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  auto* values = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  if (!values || values->GetNumberOfComponents() != Channels)
  {
    throw std::runtime_error(file.u8string() + " is no picture of penumbra-render's");
  }
  StudyPicture picture{ image->GetDimensions()[0], image->GetDimensions()[1], {} };
  picture.Values.assign(values->Begin(), values->End());
  return picture;
}

//------------------------------------------------------------------------------
void WriteStudyPicture(const StudyPicture& picture, const std::filesystem::path& file)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(picture.Width, picture.Height, 1);
  image->AllocateScalars(VTK_FLOAT, Channels);
  std::copy(
    picture.Values.begin(), picture.Values.end(), static_cast<float*>(image->GetScalarPointer()));
  vtkNew<vtkMetaImageWriter> writer;
  writer->SetFileName(file.u8string().c_str());
  writer->SetCompression(false);
  writer->SetInputData(image);
  writer->Write();
}

//------------------------------------------------------------------------------
PictureError CompareWithReference(const StudyPicture& picture, const StudyPicture& reference)
{
  RefuseOtherSize(picture, reference);
  std::vector<double> differences = DifferencesOf(picture, reference);
  PictureError error;
  for (const double difference : differences)
  {
    error.RootMeanSquare += difference * difference;
    error.Mean += difference;
    error.Largest = std::max(error.Largest, difference);
  }
  const auto count = static_cast<double>(differences.size());
  error.RootMeanSquare = std::sqrt(error.RootMeanSquare / count);
  error.Mean /= count;
  const auto rank = differences.begin() + static_cast<std::ptrdiff_t>(0.999 * (count - 1.0));
  std::nth_element(differences.begin(), rank, differences.end());
  error.Percentile999 = *rank;
  error.StructuralSimilarity = StructuralSimilarity(LuminanceOf(picture), LuminanceOf(reference));
  return error;
}

//------------------------------------------------------------------------------
double PartThatDiffers(const StudyPicture& picture, const StudyPicture& other)
{
  RefuseOtherSize(picture, other);
  // A level and a half is more than one, however its floats are rounded.
  constexpr double moreThanOne = 1.5;
  const std::vector<double> differences = DifferencesOf(picture, other);
  std::size_t pixels = 0;
  for (std::size_t at = 0; at < differences.size(); at += 3)
  {
    pixels += *std::max_element(&differences[at], &differences[at] + 3) > moreThanOne ? 1 : 0;
  }
  return 3.0 * static_cast<double>(pixels) / static_cast<double>(differences.size());
}

//------------------------------------------------------------------------------
void to_json(nlohmann::json& json, const PictureError& error)
{
  json = { { "rmse", error.RootMeanSquare }, { "mean", error.Mean },
    { "p999", error.Percentile999 }, { "largest", error.Largest },
    { "ssim", error.StructuralSimilarity } };
}

//------------------------------------------------------------------------------
void from_json(const nlohmann::json& json, PictureError& error)
{
  error = { json.at("rmse"), json.at("mean"), json.at("p999"), json.at("largest"),
    json.at("ssim") };
}

}
