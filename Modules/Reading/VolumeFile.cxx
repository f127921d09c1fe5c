#include "VolumeFile.h"

#include "Dicom/DicomFiles.h"
#include "FileContent.h"
#include "FormatReaders.h"
#include "HeaderText.h"
#include "OneLine.h"
#include "vtkImageData.h"

#include <exception>
#include <new>

namespace penumbra
{

namespace
{

bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

bool EndsWithAny(const std::string& text, const std::vector<std::string>& ends)
{
  for (const std::string& end : ends)
  {
    if (EndsWith(text, end))
    {
      return true;
    }
  }
  return false;
}

void ExpectContent(const std::filesystem::path& path, FileContent expected)
{
  const FileContent content = ContentOf(path);
  if (content != expected)
  {
    throw VolumeReadingError(std::string("its content is ") + ContentName(content) +
      ", but its name says " + ContentName(expected));
  }
}

Volume ReadByName(
  const std::filesystem::path& path, const VolumeReadingOptions& options, Warnings& warnings)
{
  const std::string name = LowerCase(path.filename().u8string());
  if (!std::filesystem::exists(path))
  {
    throw VolumeReadingError("there is no such file");
  }
  if (std::filesystem::is_directory(path))
  {
    return ReadDicomVolume(path, options, warnings);
  }
  if (EndsWith(name, ".raw"))
  {
    if (!options.raw)
    {
      throw VolumeReadingError(
        "a .raw file says nothing about itself; its dimensions and its scalar "
        "type are needed");
    }
    return ReadRawVolume(path, *options.raw, warnings);
  }
  if (EndsWithAny(name, { ".mhd", ".mha" }))
  {
    ExpectContent(path, FileContent::MetaImage);
    return ReadMetaImageVolume(path, warnings);
  }
  if (EndsWithAny(name, { ".nrrd", ".nhdr" }))
  {
    ExpectContent(path, FileContent::Nrrd);
    return ReadNrrdVolume(path, warnings);
  }
  if (EndsWith(name, ".nii.gz"))
  {
    ExpectContent(path, FileContent::Gzip);
    return ReadNiftiVolume(path, true, warnings);
  }
  if (EndsWith(name, ".nii"))
  {
    ExpectContent(path, FileContent::Nifti);
    return ReadNiftiVolume(path, false, warnings);
  }
  if (EndsWith(name, ".vti"))
  {
    ExpectContent(path, FileContent::Xml);
    return ReadXmlImageVolume(path, warnings);
  }
  if (EndsWithAny(name, { ".dcm", ".dicom" }) || MayBeDicom(path))
  {
    ContentOf(path); // which refuses what is empty or cannot be read
    return ReadDicomVolume(path, options, warnings);
  }
  throw VolumeReadingError("its extension is of no known format, and it does not start as DICOM "
                           "does; .raw, .mhd, .mha, .nrrd, .nhdr, .nii, .nii.gz, .vti or DICOM is "
                           "needed");
}

}

vtkSmartPointer<vtkImageData> ReadVolumeFile(
  const std::string& path, const VolumeReadingOptions& options, std::vector<std::string>& warnings)
{
  const std::string start = "cannot read \"" + path + "\": ";
  try
  {
    return ReadByName(std::filesystem::u8path(path), options, warnings);
  }
  catch (const std::bad_alloc&)
  {
    throw VolumeReadingError(OneLine(start + "there is not enough memory for it"));
  }
  catch (const std::exception& error)
  {
    throw VolumeReadingError(OneLine(start + error.what()));
  }
}

}
