#include "OutputFile.h"

#include "InputError.h"
#include "RenderingError.h"

#include <fstream>
#include <random>
#include <utility>

namespace penumbra
{
namespace
{
// A name that two programs writing the same file at once do not share.
std::filesystem::path NameBeside(const std::filesystem::path& file)
{
  std::random_device random;
  std::filesystem::path name = file;
  name += "." + std::to_string(random()) + ".unfinished";
  return name;
}
}

//------------------------------------------------------------------------------
OutputFile::OutputFile(const std::string& option, const std::filesystem::path& file)
  : Option(option)
  , Path(file)
  , Unfinished(NameBeside(file))
{
  const std::string what = option + " is " + file.u8string();
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
  {
    throw InputError(what + ", which is a folder; accepted: the name of a file");
  }
  const auto folder = std::filesystem::absolute(file).parent_path();
  if (!std::filesystem::is_directory(folder, error))
  {
    throw InputError(what + ", but there is no folder " + folder.u8string());
  }
  const bool canWrite = std::ofstream(this->Unfinished, std::ios::binary).is_open();
  std::filesystem::remove(this->Unfinished, error);
  if (!canWrite)
  {
    throw InputError(what + ", but no file can be written to the folder " + folder.u8string());
  }
}

//------------------------------------------------------------------------------
OutputFile::OutputFile(OutputFile&& other) noexcept
  : Option(std::move(other.Option))
  , Path(std::move(other.Path))
  , Unfinished(std::exchange(other.Unfinished, {}))
{
}

//------------------------------------------------------------------------------
OutputFile::~OutputFile()
{
  std::error_code ignored;
  if (!this->Unfinished.empty())
  {
    std::filesystem::remove(this->Unfinished, ignored);
  }
}

//------------------------------------------------------------------------------
void OutputFile::Write(const std::string& content)
{
  std::ofstream stream(this->Unfinished, std::ios::binary);
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  if (!stream)
  {
    throw RenderingError(this->Option + ": " + this->Path.u8string() + " could not be written (" +
      std::to_string(content.size()) + " bytes; is the disk full?)");
  }
}

//------------------------------------------------------------------------------
void OutputFile::Commit()
{
  std::error_code error;
  std::filesystem::rename(this->Unfinished, this->Path, error);
  if (error)
  {
    throw RenderingError(
      this->Option + ": " + this->Path.u8string() + " could not be written: " + error.message());
  }
}

}
