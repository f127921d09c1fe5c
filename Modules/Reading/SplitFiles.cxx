#include "SplitFiles.h"

#include "ByteStream.h"
#include "VolumeReadingError.h"

#include <regex>

namespace penumbra
{

std::vector<std::string> ExpandPattern(
  const std::string& pattern, std::int64_t first, std::int64_t last, std::int64_t step)
{
  // More files than any volume has slices; it keeps a damaged header from filling the memory.
  constexpr std::int64_t mostFiles = 1 << 20;
  std::smatch match;
  if (!std::regex_match(pattern, match, std::regex("([^%]*)%(0?)([1-9]?)d([^%]*)")))
  {
    throw VolumeReadingError("the names of its data files are given as \"" + pattern +
      "\"; one number such as %d or %03d in it is right");
  }
  if (step < 1 || first < 0 || last < first || (last - first) / step >= mostFiles)
  {
    throw VolumeReadingError("its data files are numbered from " + std::to_string(first) + " to " +
      std::to_string(last) + " in steps of " + std::to_string(step) +
      "; rising numbers from 0 on are needed");
  }
  const std::size_t width = match[3].length() > 0 ? std::stoul(match[3]) : 0;
  const char filling = match[2].length() > 0 ? '0' : ' ';
  std::vector<std::string> names;
  for (std::int64_t number = first; number <= last; number += step)
  {
    std::string digits = std::to_string(number);
    digits.insert(0, width > digits.size() ? width - digits.size() : 0, filling);
    names.push_back(match[1].str() + digits + match[4].str());
  }
  return names;
}

std::vector<std::filesystem::path> DataFiles(
  const std::filesystem::path& header, const std::vector<std::string>& names)
{
  std::vector<std::filesystem::path> files;
  for (const std::string& name : names)
  {
    files.push_back(header.parent_path() / std::filesystem::u8path(name));
    SizeOfFile(files.back());
  }
  return files;
}

}
