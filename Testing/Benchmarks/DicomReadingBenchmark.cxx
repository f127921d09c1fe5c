// Reads a folder of DICOM slices by GDCM alone, by vtkDICOMVolumeReader in this process and by it
// with penumbra-dicom-parser, in turns, and prints the medians of each in seconds by the clock.
// GDCM alone decodes the files in the order of their names into one piece of memory: no order, no
// geometry, no rescaling.

#include "vtkDICOMVolumeReader.h"
#include "vtkImageData.h"
#include "vtkNew.h"

#include <gdcmImage.h>
#include <gdcmImageReader.h>
#include <gdcmTrace.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace
{

namespace fs = std::filesystem;

constexpr int Turns = 9;

std::vector<std::string> FilesIn(const fs::path& folder)
{
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder))
  {
    if (entry.is_regular_file())
    {
      files.push_back(entry.path().u8string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

bool ReadByGDCM(const std::vector<std::string>& files)
{
  std::vector<char> voxels;
  for (const std::string& file : files)
  {
    gdcm::ImageReader reader;
    reader.SetFileName(file.c_str());
    if (!reader.Read())
    {
      std::cerr << file << " is no image that GDCM reads\n";
      return false;
    }
    const std::size_t size = reader.GetImage().GetBufferLength();
    voxels.reserve(size * files.size());
    voxels.resize(voxels.size() + size);
    if (!reader.GetImage().GetBuffer(voxels.data() + voxels.size() - size))
    {
      return false;
    }
  }
  return true;
}

bool ReadByPenumbra(const fs::path& folder, const char* parser)
{
  vtkNew<vtkDICOMVolumeReader> reader;
  reader->SetFileName(folder.u8string().c_str());
  reader->SetParserProgram(parser);
  reader->Update();
  return reader->GetOutput()->GetNumberOfPoints() > 0;
}

struct Way
{
  std::string name;
  std::function<bool()> read;
  std::vector<double> seconds;
};

double Median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

}

int main(int argc, char* argv[])
{
  if (argc != 2 || !fs::is_directory(fs::u8path(argv[1])))
  {
    std::cerr << "usage: DicomReadingBenchmark FOLDER, of one series of slices\n";
    return EXIT_FAILURE;
  }
  gdcm::Trace::WarningOff();
  const fs::path folder = fs::u8path(argv[1]);
  const auto files = FilesIn(folder);
  std::vector<Way> ways{
    { "GDCM alone", [&files] { return ReadByGDCM(files); }, {} },
    { "in this process", [&folder] { return ReadByPenumbra(folder, nullptr); }, {} },
    { "with the parser program",
      [&folder] { return ReadByPenumbra(folder, PENUMBRA_DICOM_PARSER); }, {} },
  };
  for (int turn = 0; turn < Turns; ++turn)
  {
    for (Way& way : ways)
    {
      const auto start = std::chrono::steady_clock::now();
      if (!way.read())
      {
        return EXIT_FAILURE;
      }
      const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
      way.seconds.push_back(passed.count());
    }
  }
  std::cout << files.size() << " files, medians of " << Turns << ":\n";
  for (const Way& way : ways)
  {
    const double seconds = Median(way.seconds);
    std::cout << "  " << way.name << ": " << seconds << " s, "
              << seconds / Median(ways.front().seconds) << " times GDCM alone\n";
  }
  return EXIT_SUCCESS;
}
