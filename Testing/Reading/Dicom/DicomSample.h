/**
 * @file DicomSample.h
 * @brief One DICOM image, element by element, and the file that holds it.
 *
 * Elements are named by the keywords of DICOM's dictionary; their values are text, several of them
 * separated by backslashes: elements["PixelSpacing"] = "0.5\\0.75".
 */
#ifndef DicomSample_h
#define DicomSample_h

#include "gdcmTransferSyntax.h"
#include "gdcmVR.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

using DicomElements = std::map<std::string, std::string>;

/// The elements in sequences of one item, such as the functional groups of a frame, by the
/// sequence's keyword.
using DicomGroups = std::map<std::string, DicomElements>;

struct DicomSample
{
  int columns = 4;
  int rows = 3;
  int frames = 1;
  int samplesPerPixel = 1;
  int bitsAllocated = 16;
  int bitsStored = 16;
  int highBit = 15;
  bool isSigned = false;

  /// What bits are set to that store nothing.
  bool unusedBits = false;

  /// The stored value of column i, row j, frame k.
  std::function<long long(int i, int j, int k)> stored;

  /// All else; also what the members above say, where it shall be wrong.
  DicomElements elements;

  /// Those of `elements` that are not of the type that they should be.
  std::map<std::string, gdcm::VR::VRType> types;

  /// Sequences of one item each, by their keywords.
  DicomGroups sequences;

  DicomGroups sharedGroups;
  std::vector<DicomGroups> frameGroups;

  gdcm::TransferSyntax::TSType transferSyntax = gdcm::TransferSyntax::ExplicitVRLittleEndian;

  /// Whether there are pixels at all.
  bool hasPixels = true;

  /// The bytes of the file.
  std::string File() const;
};

/// The file without its first 132 bytes.
std::string WithoutPreamble(const std::string& file);

/// The file's data set alone.
std::string WithoutMetaHeader(const std::string& file);

/// The numbers as text, separated by backslashes.
std::string Text(const std::vector<double>& numbers);

/// The numbers of such a text.
std::vector<double> Numbers(const std::string& text);

#endif
