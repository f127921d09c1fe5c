/**
 * @file DicomSlices.h
 * @brief The slices of a small CT series, and whether a volume lies where they say.
 */
#ifndef DicomSlices_h
#define DicomSlices_h

#include "DicomSample.h"
#include "TemporaryFolder.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

class vtkImageData;

using penumbra::TemporaryFolder;
using Vector = std::array<double, 3>;
using DicomSlices = std::vector<DicomSample>;

extern const char* const SampleSeries;

/// An image of its own UID and no geometry. Its stored values are i + 10 j + 100 k.
DicomSample UnplacedImage();

/// Axial slice of a CT: 4 x 3 pixels, 0.75 mm wide and 0.5 mm high, 2.5 mm after the slice before.
/// Its stored values are i + 10 j + 100 number^2, so that no slice lies midway between others.
DicomSample Slice(int number);

/// The slices 0 to count - 1.
DicomSlices Slices(int count);

void SetPosition(DicomSample& slice, const Vector& position);
void SetOrientation(DicomSample& slice, const Vector& row, const Vector& column);

Vector Position(const DicomSample& slice);

/// The cross product of the directions of rows and columns.
Vector Normal(const DicomSample& slice);

/// Where the slice's elements put its pixel.
Vector Place(const DicomSample& slice, int i, int j);

double Dot(const Vector& a, const Vector& b);

/// The value of a voxel by its slice's stored one.
using ValueOf = std::function<double(const DicomSample& slice, double stored)>;
double Stored(const DicomSample& slice, double stored);

/// How the volume differs from these slices, one above the other along the normal: a place or a
/// value. Empty where it does not.
std::string Difference(vtkImageData* volume, DicomSlices slices, const ValueOf& valueOf = Stored);

/// Writes each slice as a file of `folder` / `part`, 0.dcm and so on.
void WriteSlices(
  const TemporaryFolder& folder, const DicomSlices& slices, const std::string& part = "");

#endif
