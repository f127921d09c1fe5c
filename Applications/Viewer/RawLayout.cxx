#include "RawLayout.h"

#include "ScalarTypes.h"

#include <algorithm>
#include <locale>
#include <optional>
#include <regex>
#include <sstream>

namespace penumbra
{
namespace
{
constexpr std::size_t MostProposals = 12;
constexpr int LargestSide = 4096;

std::vector<std::string> AllTypes()
{
  std::istringstream words(ScalarTypeNames());
  std::vector<std::string> types;
  for (std::string word; words >> word;)
  {
    types.push_back(word);
  }
  return types;
}

template <typename Values>
std::string ToJson(const Values& values)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(17);
  const char* separator = "[";
  for (const auto& value : values)
  {
    text << separator << value;
    separator = ",";
  }
  text << "]";
  return text.str();
}

std::optional<std::array<int, 3>> DimensionsInName(const std::string& name)
{
  static const std::regex pattern("([0-9]{1,5})[xX_,-]([0-9]{1,5})[xX_,-]([0-9]{1,5})");
  std::smatch match;
  if (!std::regex_search(name, match, pattern))
  {
    return std::nullopt;
  }
  return std::array<int, 3>{ std::stoi(match[1]), std::stoi(match[2]), std::stoi(match[3]) };
}

bool IsIn(const std::vector<RawLayout>& layouts, const RawLayout& layout)
{
  return std::any_of(layouts.begin(), layouts.end(),
    [&layout](const RawLayout& other)
    { return other.Dimensions == layout.Dimensions && other.ScalarType == layout.ScalarType; });
}

class Proposals
{
public:
  explicit Proposals(std::uint64_t bytes)
    : FileBytes(bytes)
  {
  }

  void Add(const std::array<int, 3>& dimensions, const std::string& type)
  {
    RawLayout layout;
    layout.Dimensions = dimensions;
    layout.ScalarType = type;
    const bool possible =
      *std::min_element(dimensions.begin(), dimensions.end()) > 0 && dimensions[2] <= LargestSide;
    if (possible && layout.Bytes() == this->FileBytes && !IsIn(this->Layouts, layout))
    {
      this->Layouts.push_back(layout);
    }
  }

  std::vector<RawLayout> Take()
  {
    this->Layouts.resize(std::min(this->Layouts.size(), MostProposals));
    return std::move(this->Layouts);
  }

private:
  std::uint64_t FileBytes;
  std::vector<RawLayout> Layouts;
};

void AddByName(const std::string& name, Proposals& proposals)
{
  const auto dimensions = DimensionsInName(name);
  if (!dimensions)
  {
    return;
  }
  for (const std::string& type : AllTypes())
  {
    if (name.find(type) != std::string::npos && name.find("u" + type) == std::string::npos)
    {
      proposals.Add(*dimensions, type);
    }
  }
  for (const char* type : { "uint8", "uint16", "int16", "float32", "float64" })
  {
    proposals.Add(*dimensions, type);
  }
}
}

//------------------------------------------------------------------------------
int BytesOf(const std::string& scalarType)
{
  const auto digits = scalarType.find_first_of("0123456789");
  return std::stoi(scalarType.substr(digits)) / 8;
}

//------------------------------------------------------------------------------
std::uint64_t RawLayout::Bytes() const
{
  std::uint64_t bytes = static_cast<std::uint64_t>(BytesOf(this->ScalarType));
  for (const int count : this->Dimensions)
  {
    bytes *= static_cast<std::uint64_t>(count);
  }
  return this->HeaderBytes + bytes;
}

//------------------------------------------------------------------------------
std::vector<std::string> RawLayout::ToSettings() const
{
  return { "volume.dimensions=" + ToJson(this->Dimensions), "volume.scalarType=" + this->ScalarType,
    "volume.spacing=" + ToJson(this->Spacing),
    std::string("volume.byteOrder=") + (this->BigEndian ? "big" : "little"),
    "volume.headerBytes=" + std::to_string(this->HeaderBytes) };
}

//------------------------------------------------------------------------------
std::vector<RawLayout> ProposeLayouts(const std::string& fileName, std::uint64_t bytes)
{
  Proposals proposals(bytes);
  AddByName(fileName, proposals);
  const char* const types[] = { "uint8", "uint16", "int16", "float32" };
  const int sides[] = { 256, 512, 128, 64, 1024, 32, 384, 320, 192, 100, 200, 400, 500, 300, 48 };
  for (const int side : sides)
  {
    for (const char* type : types)
    {
      proposals.Add({ side, side, side }, type);
    }
  }
  for (const int side : sides)
  {
    for (const char* type : types)
    {
      const std::uint64_t slice = std::uint64_t(side) * side * BytesOf(type);
      if (bytes % slice == 0 && bytes / slice <= LargestSide)
      {
        proposals.Add({ side, side, static_cast<int>(bytes / slice) }, type);
      }
    }
  }
  return proposals.Take();
}

}
