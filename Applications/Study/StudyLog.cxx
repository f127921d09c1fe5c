#include "StudyLog.h"

#include <fstream>
#include <stdexcept>
#include <utility>

namespace penumbra
{

//------------------------------------------------------------------------------
StudyLog::StudyLog(std::filesystem::path file, const std::string& stamp)
  : File(std::move(file))
  , Stamp(stamp)
{
  std::ifstream stream(this->File);
  for (std::string line; std::getline(stream, line);)
  {
    this->EndsInLine = stream.eof();
    const auto entry = nlohmann::json::parse(line, nullptr, false);
    if (entry.is_object() && entry.value("stamp", "") == stamp && entry.contains("measurement"))
    {
      this->Measurements[entry.value("key", "")] = entry["measurement"];
    }
  }
}

//------------------------------------------------------------------------------
const nlohmann::json* StudyLog::Find(const std::string& key) const
{
  const auto found = this->Measurements.find(key);
  return found == this->Measurements.end() ? nullptr : &found->second;
}

//------------------------------------------------------------------------------
const nlohmann::json& StudyLog::Add(const std::string& key, const nlohmann::json& measurement)
{
  const nlohmann::json entry = { { "stamp", this->Stamp }, { "key", key },
    { "measurement", measurement } };
  std::ofstream stream(this->File, std::ios::app);
  stream << (this->EndsInLine ? "\n" : "");
  this->EndsInLine = false;
  stream << entry.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) << "\n";
  if (!stream.flush())
  {
    throw std::runtime_error(this->File.u8string() + " cannot be written");
  }
  return this->Measurements[key] = measurement;
}

}
