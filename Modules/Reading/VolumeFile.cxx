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

// Formats whose files say of themselves what they are.
struct NamedFormat
{
  std::vector<std::string> extensions;
  FileContent content;
  std::function<Volume(const std::filesystem::path&, Warnings&)> read;
};

const std::vector<NamedFormat>& NamedFormats()
{
  static const std::vector<NamedFormat> formats = {
    { { ".mhd", ".mha" }, FileContent::MetaImage, ReadMetaImageVolume },
    { { ".nrrd", ".nhdr" }, FileContent::Nrrd, ReadNrrdVolume },
    { { ".nii.gz" }, FileContent::Gzip,
      [](const std::filesystem::path& path, Warnings& warnings)
      { return ReadNiftiVolume(path, true, warnings); } },
    { { ".nii" }, FileContent::Nifti,
      [](const std::filesystem::path& path, Warnings& warnings)
      { return ReadNiftiVolume(path, false, warnings); } },
    { { ".vti" }, FileContent::Xml, ReadXmlImageVolume },
  };
  return formats;
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
  for (const NamedFormat& format : NamedFormats())
  {
    if (EndsWithAny(name, format.extensions))
    {
      ExpectContent(path, format.content);
      return format.read(path, warnings);
    }
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
