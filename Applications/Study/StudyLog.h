/**
 * @class   StudyLog
 * @brief   what a study has measured so far, kept so that it can go on where it stopped
 *
 * A file of one JSON object a line. Each is written as soon as it is known; one that was cut off is
 * left out. Measurements of other versions, or of scenes that have changed since, do not count.
 */

#ifndef StudyLog_h
#define StudyLog_h

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <string>

namespace penumbra
{

class StudyLog
{
public:
  /// `stamp` is what all of its measurements have in common; others in the file are forgotten.
  StudyLog(std::filesystem::path file, const std::string& stamp);

  /// Null where there is none yet.
  const nlohmann::json* Find(const std::string& key) const;

  /// @throw std::runtime_error where it cannot be written.
  const nlohmann::json& Add(const std::string& key, const nlohmann::json& measurement);

private:
  std::filesystem::path File;
  std::string Stamp;
  std::map<std::string, nlohmann::json> Measurements;
  /// The file's last line was cut off.
  bool EndsInLine = false;
};

}

#endif
