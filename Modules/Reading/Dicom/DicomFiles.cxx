#include "DicomFiles.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <set>
#include <system_error>

namespace penumbra
{

namespace
{

namespace fs = std::filesystem;

// More is no folder of one patient; searching it would take minutes.
constexpr std::size_t MostFiles = 100000;

constexpr std::size_t PreambleBytes = 128;
constexpr std::array<char, 4> Magic{ 'D', 'I', 'C', 'M' };

// A tag and a length.
constexpr std::size_t ShortestElement = 8;

using FirstBytes = std::array<char, PreambleBytes + Magic.size() + ShortestElement>;

unsigned int ByteAt(const FirstBytes& bytes, std::size_t index)
{
  return static_cast<unsigned char>(bytes[index]);
}

// Files without preamble start with an element of a low group, in either byte order: its tag, and
// a type of two capital letters or a length of less than 64 KiB.
bool StartsWithElement(const FirstBytes& bytes)
{
  const auto isGroup = [](unsigned int group)
  { return group == 0x0002 || group == 0x0008 || group == 0x0010; };
  const unsigned int littleGroup = ByteAt(bytes, 0) | ByteAt(bytes, 1) << 8;
  const unsigned int bigGroup = ByteAt(bytes, 0) << 8 | ByteAt(bytes, 1);
  const auto isCapital = [&bytes](std::size_t index)
  { return bytes[index] >= 'A' && bytes[index] <= 'Z'; };
  const bool hasType = isCapital(4) && isCapital(5);
  const bool hasLittleLength = ByteAt(bytes, 6) == 0 && ByteAt(bytes, 7) == 0;
  const bool hasBigLength = ByteAt(bytes, 4) == 0 && ByteAt(bytes, 5) == 0;
  return (isGroup(littleGroup) && (hasType || hasLittleLength)) ||
    (isGroup(bigGroup) && (hasType || hasBigLength));
}

// The file system's own errors have several lines and name the path again.
[[noreturn]] void ThrowUnreadable(const fs::path& folder, const std::error_code& error)
{
  throw VolumeReadingError(
    "the folder " + folder.u8string() + " cannot be read: " + error.message());
}

class FolderSearch
{
public:
  explicit FolderSearch(const ReadingProgress& progress)
    : Progress(progress)
  {
  }

  void Search(const fs::path& folder)
  {
    std::error_code error;
    const fs::path whole = fs::canonical(folder, error);
    if (error || !this->Folders.insert(whole).second)
    {
      return; // a link that leads nowhere, or back
    }
    const bool isFirst = this->Folders.size() == 1;
    fs::directory_iterator entry(folder, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error))
    {
      this->Look(*entry);
    }
    if (isFirst)
    {
      this->Unreadable = error;
    }
  }

  void ThrowIfUnreadable(const fs::path& folder) const
  {
    if (this->Unreadable)
    {
      ThrowUnreadable(folder, this->Unreadable);
    }
  }

  std::vector<fs::path> TakeFiles()
  {
    std::sort(this->Files.begin(), this->Files.end());
    return std::move(this->Files);
  }

private:
  void Look(const fs::directory_entry& entry)
  {
    if (!this->Progress(0.0))
    {
      throw ReadingCancelled();
    }
    std::error_code ignored;
    if (entry.is_directory(ignored))
    {
      this->Search(entry.path());
      return;
    }
    if (!entry.is_regular_file(ignored))
    {
      return;
    }
    if (++this->Seen > MostFiles)
    {
      throw VolumeReadingError("the folder has more than " + std::to_string(MostFiles) +
        " files; name the one that holds the images");
    }
    const fs::path whole = fs::canonical(entry.path(), ignored);
    if (!IsDicomDirectory(entry.path()) && this->Known.insert(whole).second &&
      MayBeDicom(entry.path()))
    {
      this->Files.push_back(entry.path());
    }
  }

  const ReadingProgress& Progress;
  std::set<fs::path> Folders;
  std::set<fs::path> Known;
  std::vector<fs::path> Files;
  std::error_code Unreadable;
  std::size_t Seen = 0;
};

}

bool MayBeDicom(const fs::path& path)
{
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) // a pipe would be waited for
  {
    return false;
  }
  FirstBytes bytes{};
  std::ifstream file(path, std::ios::binary);
  file.read(bytes.data(), bytes.size());
  const auto count = static_cast<std::size_t>(file.gcount());
  const bool hasMagic =
    count == bytes.size() && std::equal(Magic.begin(), Magic.end(), bytes.begin() + PreambleBytes);
  return hasMagic || (count >= ShortestElement && StartsWithElement(bytes));
}

bool IsDicomDirectory(const fs::path& path)
{
  std::string name = path.filename().u8string();
  std::transform(name.begin(), name.end(), name.begin(),
    [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
  return name == "DICOMDIR";
}

std::vector<fs::path> FindDicomFiles(const fs::path& folder, const ReadingProgress& progress)
{
  FolderSearch search(progress);
  search.Search(folder);
  search.ThrowIfUnreadable(folder);
  return search.TakeFiles();
}

}
