#include "FileContent.h"

#include "FileBytes.h"
#include "VolumeReadingError.h"

#include <string>

namespace penumbra
{

namespace
{

bool Holds(const std::string& bytes, std::size_t position, const std::string& expected)
{
  return bytes.size() >= position + expected.size() &&
    bytes.compare(position, expected.size(), expected) == 0;
}

// MetaImage has no magic word: its header is lines of "Key = value".
bool StartsAsMetaImage(const std::string& bytes)
{
  const std::string word = bytes.substr(0, bytes.find_first_of(" \t=:\r\n"));
  for (const char* key : { "ObjectType", "NDims", "Comment", "DimSize", "BinaryData", "ID",
         "ParentID", "TransformType", "AcquisitionDate", "Modality", "ElementType", "Name" })
  {
    if (word == key)
    {
      return true;
    }
  }
  return false;
}

}

FileContent ContentOf(const std::filesystem::path& path)
{
  if (SizeOfFile(path) == 0)
  {
    throw VolumeReadingError("the file is empty");
  }
  const std::string bytes = ReadBytes(path, 0, 352);
  if (Holds(bytes, 0, "\x1f\x8b"))
  {
    return FileContent::Gzip;
  }
  if (Holds(bytes, 0, "NRRD"))
  {
    return FileContent::Nrrd;
  }
  if (Holds(bytes, 344, "n+1") || Holds(bytes, 344, "ni1") || Holds(bytes, 4, "n+2") ||
    Holds(bytes, 4, "ni2"))
  {
    return FileContent::Nifti;
  }
  if (Holds(bytes, 128, "DICM"))
  {
    return FileContent::Dicom;
  }
  if (Holds(bytes, 0, "<?xml") || Holds(bytes, 0, "<VTKFile"))
  {
    return FileContent::Xml;
  }
  return StartsAsMetaImage(bytes) ? FileContent::MetaImage : FileContent::Unknown;
}

const char* ContentName(FileContent content)
{
  switch (content)
  {
    case FileContent::Dicom:
      return "DICOM";
    case FileContent::Gzip:
      return "gzip-compressed";
    case FileContent::MetaImage:
      return "MetaImage";
    case FileContent::Nifti:
      return "NIfTI";
    case FileContent::Nrrd:
      return "NRRD";
    case FileContent::Xml:
      return "XML";
    case FileContent::Unknown:
      break;
  }
  return "unknown";
}

}
