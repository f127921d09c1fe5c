/**
 * @class   OutputFile
 * @brief   a file that is there either whole or not at all
 *
 * Whether it can be written is found out when it is named, before any work is done for it. Its
 * content goes to another name beside it and takes its own name last. Where the name is that of a
 * symbolic link, what it leads to is written, and the link stays.
 */

#ifndef OutputFile_h
#define OutputFile_h

#include <filesystem>
#include <string>

namespace penumbra
{

class OutputFile
{
public:
  /// @throw InputError where no file can be written there, or where a link leads to a file with
  /// another extension, which is of another kind. `option` names it in the message.
  OutputFile(const std::string& option, const std::filesystem::path& file);
  ~OutputFile();
  OutputFile(OutputFile&& other) noexcept;
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  OutputFile& operator=(OutputFile&&) = delete;

  /// The file that is written; where a link was named, what it leads to.
  const std::filesystem::path& GetTarget() const { return this->Target; }

  /// Writes the content under the other name. @throw RenderingError where that fails.
  void Write(const std::string& content);

  /// Gives the file its name. @throw RenderingError where that fails.
  void Commit();

private:
  std::string Option;
  std::filesystem::path Path;
  std::filesystem::path Target;
  std::filesystem::path Unfinished;
};

}

#endif
