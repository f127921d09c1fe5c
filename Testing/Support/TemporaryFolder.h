/**
 * @file TemporaryFolder.h
 * @brief A folder of a test's own.
 */
#ifndef TemporaryFolder_h
#define TemporaryFolder_h

#include <filesystem>
#include <string>
#include <vector>

namespace penumbra
{
/// A new, empty folder, with a space in its name, that is removed with all that is in it.
class TemporaryFolder
{
public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string PathOf(const std::string& name) const;
  /// The path of a new file with these bytes; folders in its name are made.
  std::string Write(const std::string& name, const std::string& bytes) const;
  /// What the folder holds, sorted.
  std::vector<std::string> Names() const;

private:
  std::filesystem::path Path;
};
}

#endif
