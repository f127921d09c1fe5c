#include "XmlDocument.h"

#include "ByteStream.h"
#include "HeaderText.h"
#include "VolumeReadingError.h"

#include <array>
#include <utility>

namespace penumbra
{

namespace
{

// The bytes of the document one by one, and where they are.
class Characters
{
public:
  explicit Characters(const std::filesystem::path& path)
    : Bytes(OpenBytes(path, 0, false))
  {
  }

  bool Next(char& letter)
  {
    if (this->Used == this->Filled)
    {
      this->Filled =
        static_cast<std::size_t>(this->Bytes->Read(this->Buffer.data(), this->Buffer.size()));
      this->Used = 0;
    }
    if (this->Used == this->Filled)
    {
      return false;
    }
    letter = this->Buffer[this->Used++];
    ++this->Count;
    return true;
  }

  std::uint64_t Position() const { return this->Count; }

private:
  std::unique_ptr<ByteStream> Bytes;
  std::array<char, 1 << 14> Buffer;
  std::size_t Filled = 0;
  std::size_t Used = 0;
  std::uint64_t Count = 0;
};

bool SkipContent(Characters& characters)
{
  char letter = 0;
  while (characters.Next(letter))
  {
    if (letter == '<')
    {
      return true;
    }
  }
  return false;
}

bool StartsWith(const std::string& text, const std::string& start)
{
  return text.compare(0, start.size(), start) == 0;
}

bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

// What stands between < and >. A > may stand in quotes and in comments.
std::string ReadTag(Characters& characters)
{
  constexpr std::size_t longestTag = 1 << 16;
  std::string tag;
  char quote = 0;
  char letter = 0;
  while (characters.Next(letter))
  {
    const bool isComment = StartsWith(tag, "!--");
    if (letter == '>' && quote == 0 && (!isComment || EndsWith(tag, "--")))
    {
      return tag;
    }
    if (!isComment && (letter == '"' || letter == '\'') && (quote == 0 || quote == letter))
    {
      quote = quote == 0 ? letter : 0;
    }
    tag += letter;
    if (tag.size() > longestTag)
    {
      break;
    }
  }
  throw VolumeReadingError("its XML is damaged: \"<" + tag.substr(0, 40) + "...\" has no end");
}

std::string Unescaped(std::string text)
{
  // & last, or "&amp;lt;" would be taken for "<".
  const std::pair<const char*, const char*> entities[] = { { "&lt;", "<" }, { "&gt;", ">" },
    { "&quot;", "\"" }, { "&apos;", "'" }, { "&amp;", "&" } };
  for (const auto& [escaped, plain] : entities)
  {
    std::size_t position = 0;
    while ((position = text.find(escaped, position)) != std::string::npos)
    {
      text.replace(position, std::string(escaped).size(), plain);
      position += 1;
    }
  }
  return text;
}

XmlElement ParseStartTag(const std::string& tag)
{
  constexpr const char* blanks = " \t\r\n";
  XmlElement element;
  std::size_t position = tag.find_first_of(blanks);
  element.name = tag.substr(0, position);
  while ((position = tag.find_first_not_of(blanks, position)) != std::string::npos)
  {
    const std::size_t equals = tag.find('=', position);
    const std::size_t open = tag.find_first_of("\"'", equals);
    const std::size_t close = open == std::string::npos ? open : tag.find(tag[open], open + 1);
    if (equals == std::string::npos || close == std::string::npos)
    {
      throw VolumeReadingError("its XML is damaged at \"<" + tag.substr(0, 40) + "\"");
    }
    element.attributes[Trimmed(tag.substr(position, equals - position))] =
      Unescaped(tag.substr(open + 1, close - open - 1));
    position = close + 1;
  }
  return element;
}

}

std::optional<std::string> XmlElement::Attribute(const std::string& attribute) const
{
  const auto found = this->attributes.find(attribute);
  return found == this->attributes.end() ? std::nullopt : std::optional<std::string>(found->second);
}

std::string XmlElement::Needed(const std::string& attribute) const
{
  const auto value = this->Attribute(attribute);
  if (!value)
  {
    throw VolumeReadingError("its element " + this->name + " lacks the attribute " + attribute);
  }
  return *value;
}

std::vector<XmlElement> ReadXmlElements(const std::filesystem::path& path)
{
  std::vector<XmlElement> elements;
  std::vector<std::size_t> open;
  Characters characters(path);
  while (SkipContent(characters))
  {
    if (!elements.empty() && elements.back().contentEnd == 0)
    {
      elements.back().contentEnd = characters.Position() - 1;
    }
    std::string tag = ReadTag(characters);
    if (tag.empty() || tag[0] == '?' || tag[0] == '!')
    {
      continue;
    }
    if (tag[0] == '/')
    {
      if (open.empty() || elements[open.back()].name != Trimmed(tag.substr(1)))
      {
        throw VolumeReadingError("its XML is damaged: <" + tag + "> ends what has not begun");
      }
      open.pop_back();
      continue;
    }
    const bool isEmpty = tag.back() == '/';
    tag.resize(tag.size() - (isEmpty ? 1 : 0));
    elements.push_back(ParseStartTag(tag));
    elements.back().parent = open.empty() ? elements.size() - 1 : open.back();
    elements.back().contentBegin = characters.Position();
    if (elements.back().name == "AppendedData")
    {
      elements.back().contentEnd = SizeOfFile(path);
      return elements;
    }
    if (!isEmpty)
    {
      open.push_back(elements.size() - 1);
    }
  }
  if (elements.empty() || !open.empty())
  {
    throw VolumeReadingError("its XML has no end; the file is cut short");
  }
  return elements;
}

}
