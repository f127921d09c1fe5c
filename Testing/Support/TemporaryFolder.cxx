#include "TemporaryFolder.h"

#include <algorithm>
#include <fstream>
#include <random>
#include <system_error>

namespace penumbra
{

//------------------------------------------------------------------------------
TemporaryFolder::TemporaryFolder()
{
  std::random_device random;
  do
  {
    this->Path = std::filesystem::temp_directory_path() /
      ("penumbra " + std::to_string(random()) + std::to_string(random()));
  } while (!std::filesystem::create_directory(this->Path));
}

//------------------------------------------------------------------------------
TemporaryFolder::~TemporaryFolder()
{
  std::error_code ignored;
  std::filesystem::remove_all(this->Path, ignored);
}

//------------------------------------------------------------------------------
std::string TemporaryFolder::PathOf(const std::string& name) const
{
  return (this->Path / name).u8string();
}

//------------------------------------------------------------------------------
std::string TemporaryFolder::Write(const std::string& name, const std::string& bytes) const
{
  std::filesystem::create_directories((this->Path / name).parent_path());
  std::ofstream(this->Path / name, std::ios::binary) << bytes;
  return this->PathOf(name);
}

//------------------------------------------------------------------------------
std::vector<std::string> TemporaryFolder::Names() const
{
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(this->Path))
  {
    names.push_back(entry.path().filename().u8string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}
