/**
 * @file    HeaderText.h
 * @brief   lines, words and numbers of the text headers of volume files
 *
 * Numbers are read the same way whatever the locale.
 */

#ifndef HeaderText_h
#define HeaderText_h

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace penumbra
{

/**
 * The lines of a header at the start of a file, of which at most 4 MiB are looked at.
 */
class HeaderLines
{
public:
  explicit HeaderLines(const std::filesystem::path& path);

  /**
   * Puts the next line, without its line end, into `line`; false at the end of the file.
   */
  bool Next(std::string& line);

  /**
   * Bytes from the start of the file to the end of the last line.
   */
  std::uint64_t Position() const { return this->NextLine; }

private:
  std::string Text;
  std::size_t NextLine = 0;
};

std::string Trimmed(const std::string& text);
std::string LowerCase(std::string text);
std::vector<std::string> Words(const std::string& text);

/**
 * The whole of `word` as a number, where "nan" and "inf" are numbers too, or as an integer. Both
 * throw VolumeReadingError that calls the number `name` where `word` is something else.
 */
double ToNumber(const std::string& word, const std::string& name);
std::int64_t ToInteger(const std::string& word, const std::string& name);

/**
 * `count` numbers separated by blanks; throws VolumeReadingError where there are more, or fewer.
 */
std::vector<double> ToNumbers(const std::string& text, std::size_t count, const std::string& name);
std::vector<std::int64_t> ToIntegers(
  const std::string& text, std::size_t count, const std::string& name);

}

#endif
