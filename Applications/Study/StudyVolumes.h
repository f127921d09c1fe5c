/**
 * @file    StudyVolumes.h
 * @brief   volumes that are known in closed form, for studies
 */

#ifndef StudyVolumes_h
#define StudyVolumes_h

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <array>
#include <filesystem>
#include <functional>
#include <string>

class vtkImageData;

namespace penumbra
{

struct StudyGrid
{
  std::array<int, 3> Dimensions = { 64, 64, 64 };
  std::array<double, 3> Spacing = { 1.0, 1.0, 1.0 };
  std::array<double, 3> Origin = { 0.0, 0.0, 0.0 };
  int ScalarType = VTK_UNSIGNED_CHAR;
};

/// The value at a voxel whose indices are stretched to -1 to 1 along each axis; asked by several
/// threads at once.
using StudyField = std::function<double(double x, double y, double z)>;

/// Integer types take the nearest value that they can hold.
vtkSmartPointer<vtkImageData> MakeStudyVolume(const StudyGrid& grid, const StudyField& field);

/// A .vti file, for MetaImage drops axes of one voxel. @throw std::runtime_error where it cannot be
/// written.
void WriteStudyVolume(vtkImageData* volume, const std::filesystem::path& file);

/// Values of 0 to 255.
///@{
/// Two balls, one before the other, with soft edges.
double TwoBalls(double x, double y, double z);
/// Concentric shells that let light through.
double Shells(double x, double y, double z);
/// A floor with a bar above it.
double FloorAndBar(double x, double y, double z);
/// Branches that fork five times, finer than a voxel at their ends.
double Tree(double x, double y, double z);
/// A block with bores, pipes and thin walls, of two materials.
double Casting(double x, double y, double z);
/// Haze that thickens downwards, without a surface.
double Haze(double x, double y, double z);
///@}

}

#endif
