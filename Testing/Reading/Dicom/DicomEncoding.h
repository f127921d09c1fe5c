/**
 * @file DicomEncoding.h
 * @brief Elements of a DICOM data set, made of keywords and text.
 */
#ifndef DicomEncoding_h
#define DicomEncoding_h

#include "gdcmDataElement.h"
#include "gdcmDataSet.h"

#include <string>
#include <vector>

struct DicomElementKind
{
  gdcm::Tag tag;
  gdcm::VR::VRType type;
};

/// Throws std::invalid_argument where DICOM's dictionary does not have the keyword.
DicomElementKind FindElement(const std::string& keyword);

/// What backslashes separate.
std::vector<std::string> Parts(const std::string& text);

/// The bytes that hold these values.
std::string Value(const std::string& text, gdcm::VR::VRType type);

gdcm::DataElement Element(const gdcm::Tag& tag, gdcm::VR::VRType type, const std::string& bytes);

gdcm::DataElement Sequence(const std::string& keyword, const std::vector<gdcm::DataSet>& items);

#endif
