#include "SplitFiles.h"

#include "FileBytes.h"
#include "VolumeReadingError.h"

namespace penumbra
{

namespace
{

struct Pattern
{
  std::string before;
  std::string after;
  std::size_t width = 0;
  char filling = ' ';
};

// Only what %d knows is taken from the file, never a format for printf.
Pattern ParsePattern(const std::string& text)
{
  Pattern pattern;
  std::size_t position = text.find('%');
  const auto letter = [&](char first, char last)
  { return position < text.size() && text[position] >= first && text[position] <= last; };
  pattern.before = text.substr(0, position);
  position = position == std::string::npos ? text.size() : position + 1;
  if (letter('0', '0'))
  {
    pattern.filling = '0';
    ++position;
  }
  if (letter('1', '9'))
  {
    pattern.width = static_cast<std::size_t>(text[position++] - '0');
  }
  const bool isNumber = letter('d', 'd');
  pattern.after = isNumber ? text.substr(position + 1) : std::string();
  if (!isNumber || pattern.after.find('%') != std::string::npos)
  {
    throw VolumeReadingError("the names of its data files are given as \"" + text +
      "\"; one number such as %d or %03d in it is right");
  }
  return pattern;
}

}

std::vector<std::string> ExpandPattern(
  const std::string& pattern, std::int64_t first, std::int64_t last, std::int64_t step)
{
  // More files than any volume has slices; it keeps a damaged header from filling the memory.
  constexpr std::int64_t mostFiles = 1 << 16;
  const Pattern parsed = ParsePattern(pattern);
  if (step < 1 || first < 0 || last < first || (last - first) / step >= mostFiles)
  {
    throw VolumeReadingError("its data files are numbered from " + std::to_string(first) + " to " +
      std::to_string(last) + " in steps of " + std::to_string(step) +
      "; rising numbers from 0 on are needed");
  }
  std::vector<std::string> names;
  for (std::int64_t file = 0; file <= (last - first) / step; ++file)
  {
    std::string digits = std::to_string(first + file * step);
    digits.insert(
      0, parsed.width > digits.size() ? parsed.width - digits.size() : 0, parsed.filling);
    names.push_back(parsed.before + digits + parsed.after);
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
