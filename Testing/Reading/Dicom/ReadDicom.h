/**
 * @file ReadDicom.h
 * @brief What vtkDICOMVolumeReader makes of a path.
 *
 * Whatever is read, the promises that hold for all are checked: an error is one line, told once by
 * vtkErrorMacro, and leaves an empty output; else there is one scalar per voxel; each warning is
 * one line. Nothing is shown on the terminal.
 */
#ifndef ReadDicom_h
#define ReadDicom_h

#include "DicomSlices.h"
#include "vtkDICOMVolumeReader.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

struct DicomReading
{
  vtkSmartPointer<vtkImageData> volume;
  std::vector<std::string> warnings;
  /// The line that vtkErrorMacro tells.
  std::string error;

  /// All warnings, one line each.
  std::string Warnings() const;
  /// The only value of a text array of the field data; empty where there is none.
  std::string Field(const char* name) const;
};

/// The ways to parse: in the reader's process (an empty name) and by the program.
std::vector<std::string> Parsers();

DicomReading Update(vtkDICOMVolumeReader* reader);

/// Whether the text has a part that fits the expression, in upper or lower case.
bool Mentions(const std::string& text, const std::string& expression);

/// The path is a folder's or a file's.
DicomReading ReadDicom(const std::string& path, const std::string& parserProgram = "");

/// A folder of these slices alone.
DicomReading ReadSlices(const DicomSlices& slices, const std::string& parserProgram = "");

#endif
