#include "HeaderText.h"

#include "FileBytes.h"
#include "VolumeReadingError.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <locale>
#include <sstream>

namespace penumbra
{

namespace
{

constexpr const char* Blanks = " \t\r\n\v\f";
constexpr std::uint64_t LargestHeader = 4 << 20;

std::vector<std::string> CountedWords(
  const std::string& text, std::size_t count, const std::string& name)
{
  std::vector<std::string> words = Words(text);
  if (words.size() != count)
  {
    throw VolumeReadingError(
      name + " is \"" + Trimmed(text) + "\"; " + std::to_string(count) + " numbers are needed");
  }
  return words;
}

}

HeaderLines::HeaderLines(const std::filesystem::path& path)
  : Text(ReadBytes(path, 0, LargestHeader))
{
}

bool HeaderLines::Next(std::string& line)
{
  if (this->NextLine >= this->Text.size())
  {
    return false;
  }
  const std::size_t end = std::min(this->Text.find('\n', this->NextLine), this->Text.size());
  line = this->Text.substr(this->NextLine, end - this->NextLine);
  if (!line.empty() && line.back() == '\r')
  {
    line.pop_back();
  }
  this->NextLine = std::min(end + 1, this->Text.size());
  return true;
}

std::string Trimmed(const std::string& text)
{
  const std::size_t first = text.find_first_not_of(Blanks);
  return first == std::string::npos ? std::string()
                                    : text.substr(first, text.find_last_not_of(Blanks) - first + 1);
}

std::string LowerCase(std::string text)
{
  for (char& letter : text)
  {
    letter = letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  }
  return text;
}

std::vector<std::string> Words(const std::string& text)
{
  std::vector<std::string> words;
  std::size_t start = text.find_first_not_of(Blanks);
  while (start != std::string::npos)
  {
    const std::size_t end = text.find_first_of(Blanks, start);
    words.push_back(text.substr(start, end - start));
    start = text.find_first_not_of(Blanks, end);
  }
  return words;
}

double ToNumber(const std::string& word, const std::string& name)
{
  const std::string lower = LowerCase(word);
  const bool negative = lower.compare(0, 1, "-") == 0;
  const std::string unsignedWord =
    negative || lower.compare(0, 1, "+") == 0 ? lower.substr(1) : lower;
  if (unsignedWord == "nan")
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (unsignedWord == "inf" || unsignedWord == "infinity")
  {
    const double infinity = std::numeric_limits<double>::infinity();
    return negative ? -infinity : infinity;
  }
  std::istringstream stream(word);
  stream.imbue(std::locale::classic());
  double number = 0.0;
  if (!(stream >> number) || stream.peek() != std::istringstream::traits_type::eof())
  {
    throw VolumeReadingError(name + " is \"" + word + "\"; a number is needed");
  }
  return number;
}

std::int64_t ToInteger(const std::string& word, const std::string& name)
{
  std::int64_t integer = 0;
  const char* const end = word.data() + word.size();
  const auto result = std::from_chars(word.data(), end, integer);
  if (result.ec != std::errc() || result.ptr != end)
  {
    throw VolumeReadingError(name + " is \"" + word + "\"; an integer of 64 bits is needed");
  }
  return integer;
}

std::vector<double> ToNumbers(const std::string& text, std::size_t count, const std::string& name)
{
  std::vector<double> numbers;
  for (const std::string& word : CountedWords(text, count, name))
  {
    numbers.push_back(ToNumber(word, name));
  }
  return numbers;
}

std::vector<std::int64_t> ToIntegers(
  const std::string& text, std::size_t count, const std::string& name)
{
  std::vector<std::int64_t> integers;
  for (const std::string& word : CountedWords(text, count, name))
  {
    integers.push_back(ToInteger(word, name));
  }
  return integers;
}

}
