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
namespace fs = std::filesystem;

// A name that two programs writing the same file at once do not share. It is short, as the file's
// own name may be as long as names can be.
fs::path NameBeside(const fs::path& file)
{
  std::random_device random;
  return file.parent_path() / ("penumbra-" + std::to_string(random()) + ".unfinished");
}

// Also where there is no file yet.
fs::path FollowLinks(const std::string& what, fs::path file)
{
  constexpr int mostLinks = 40;
  std::error_code error;
  for (int links = 0; fs::is_symlink(file, error); ++links)
  {
    if (links == mostLinks)
    {
      throw InputError(what + ", a link that leads in a circle; accepted: the name of a file");
    }
    file = file.parent_path() / fs::read_symlink(file, error);
  }
  return file;
}

void RefuseOtherKind(const std::string& what, const fs::path& file, const fs::path& target)
{
  if (target.extension() != file.extension())
  {
    throw InputError(what + ", a link to " + target.u8string() +
      "; accepted: a link to a name that ends in " + file.extension().u8string());
  }
}
}

//------------------------------------------------------------------------------
OutputFile::OutputFile(const std::string& option, const std::filesystem::path& file)
  : Option(option)
  , Path(file)
{
  const std::string what = option + " is " + file.u8string();
  this->Target = FollowLinks(what, file);
  RefuseOtherKind(what, file, this->Target);
  std::error_code error;
  if (fs::is_directory(this->Target, error))
  {
    throw InputError(what + ", which is a folder; accepted: the name of a file");
  }
  const auto folder = fs::absolute(this->Target).parent_path();
  if (!fs::is_directory(folder, error))
  {
    throw InputError(what + ", but there is no folder " + folder.u8string());
  }
  if (fs::status(this->Target, error).type() == fs::file_type::none)
  {
    throw InputError(what + ", which no file can be named: " + error.message());
  }
  const fs::path unfinished = NameBeside(this->Target);
  const bool canWrite = std::ofstream(unfinished, std::ios::binary).is_open();
  fs::remove(unfinished, error);
  if (!canWrite)
  {
    throw InputError(what + ", but no file can be written to the folder " + folder.u8string());
  }
  this->Unfinished = unfinished;
}

//------------------------------------------------------------------------------
OutputFile::OutputFile(OutputFile&& other) noexcept
  : Option(std::move(other.Option))
  , Path(std::move(other.Path))
  , Target(std::move(other.Target))
  , Unfinished(std::exchange(other.Unfinished, {}))
{
}

//------------------------------------------------------------------------------
OutputFile::~OutputFile()
{
  std::error_code ignored;
  if (!this->Unfinished.empty())
  {
    fs::remove(this->Unfinished, ignored);
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
  fs::rename(this->Unfinished, this->Target, error);
  if (error)
  {
    throw RenderingError(
      this->Option + ": " + this->Path.u8string() + " could not be written: " + error.message());
  }
}

}
