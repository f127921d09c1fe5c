#include "NrrdHeader.h"

#include "HeaderText.h"
#include "VolumeReadingError.h"

#include <algorithm>

namespace penumbra
{

std::optional<std::string> NrrdHeader::Value(const std::string& name) const
{
  const auto field = this->fields.find(name);
  return field == this->fields.end() ? std::nullopt : std::optional<std::string>(field->second);
}

std::string NrrdHeader::Needed(const std::string& name) const
{
  const auto value = this->Value(name);
  if (!value || value->empty())
  {
    throw VolumeReadingError("its header lacks the field \"" + name + "\"");
  }
  return *value;
}

std::optional<std::vector<std::string>> NrrdHeader::WordsPerAxis(const std::string& name) const
{
  const auto value = this->Value(name);
  if (!value)
  {
    return std::nullopt;
  }
  std::vector<std::string> words = Words(*value);
  if (words.size() != this->NumberOfAxes())
  {
    throw VolumeReadingError("the field \"" + name + "\" is \"" + *value +
      "\"; one value for each of " + std::to_string(this->NumberOfAxes()) + " axes is needed");
  }
  return words;
}

std::size_t NrrdHeader::NumberOfAxes() const
{
  // NRRD's own limit.
  constexpr std::int64_t mostAxes = 16;
  const std::int64_t axes = ToInteger(this->Needed("dimension"), "the field \"dimension\"");
  if (axes < 1 || axes > mostAxes)
  {
    throw VolumeReadingError(
      "the field \"dimension\" is " + std::to_string(axes) + "; 2 or 3 axes are needed");
  }
  return static_cast<std::size_t>(axes);
}

namespace
{

// "field: value"; lines "key:=value" and comments say nothing about the volume.
void AddField(const std::string& line, NrrdHeader& header)
{
  const std::size_t colon = line.find(':');
  if (line[0] == '#' || colon == std::string::npos || line.compare(colon, 2, ":=") == 0)
  {
    return;
  }
  std::string name = LowerCase(line.substr(0, colon));
  name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
  header.fields[name] = Trimmed(line.substr(colon + 1));
}

}

NrrdHeader ReadNrrdHeader(const std::filesystem::path& path)
{
  NrrdHeader header;
  HeaderLines lines(path);
  std::string line;
  if (!lines.Next(line) || line.compare(0, 7, "NRRD000") != 0)
  {
    throw VolumeReadingError("it does not begin with NRRD000; a NRRD file does");
  }
  bool isList = false;
  while (lines.Next(line) && !line.empty())
  {
    if (isList)
    {
      header.listedFiles.push_back(Trimmed(line));
      continue;
    }
    AddField(line, header);
    // LIST is the last field: the lines after it are names of files.
    isList = header.Value("datafile").value_or("").compare(0, 4, "LIST") == 0;
  }
  const bool endedByBlankLine = line.empty();
  if (!endedByBlankLine && !header.Value("datafile"))
  {
    throw VolumeReadingError("its header has no end; the file is cut short");
  }
  header.size = lines.Position();
  return header;
}

}
