#include "VolumeFile.h"

#include "FileContent.h"
#include "FormatReaders.h"
#include "HeaderText.h"
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

Volume ReadByName(const std::filesystem::path& path, const std::optional<RawVolumeGeometry>& raw,
  Warnings& warnings)
{
  const std::string name = LowerCase(path.filename().u8string());
  if (!std::filesystem::exists(path))
  {
    throw VolumeReadingError("there is no such file");
  }
  if (std::filesystem::is_directory(path))
  {
    throw VolumeReadingError("it is a folder, and DICOM is not read yet; a file is needed");
  }
  if (EndsWith(name, ".raw"))
  {
    if (!raw)
    {
      throw VolumeReadingError(
        "a .raw file says nothing about itself; its dimensions and its scalar "
        "type are needed");
    }
    return ReadRawVolume(path, *raw, warnings);
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
  if (EndsWith(name, ".dcm") || ContentOf(path) == FileContent::Dicom)
  {
    throw VolumeReadingError("DICOM is not read yet");
  }
  throw VolumeReadingError("its extension is of no known format; .raw, .mhd, .mha, .nrrd, .nhdr, "
                           ".nii, .nii.gz or .vti is needed");
}

// Names and texts from files may hold line ends.
std::string OneLine(std::string text)
{
  for (char& letter : text)
  {
    const auto code = static_cast<unsigned char>(letter);
    letter = code < ' ' || code == 127 ? ' ' : letter;
  }
  constexpr std::size_t longest = 1000;
  return text.size() > longest ? text.substr(0, longest) + "..." : text;
}

}

vtkSmartPointer<vtkImageData> ReadVolumeFile(const std::string& path,
  const std::optional<RawVolumeGeometry>& raw, std::vector<std::string>& warnings)
{
  const std::string start = "cannot read \"" + path + "\": ";
  try
  {
    return ReadByName(std::filesystem::u8path(path), raw, warnings);
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
