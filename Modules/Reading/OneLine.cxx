#include "OneLine.h"

namespace penumbra
{

namespace
{

// Whether it is within a character of UTF-8.
bool IsContinuation(char byte)
{
  return (static_cast<unsigned char>(byte) & 0xc0) == 0x80;
}

}

std::string OneLine(std::string text)
{
  for (char& letter : text)
  {
    const auto code = static_cast<unsigned char>(letter);
    letter = code < ' ' || code == 127 ? ' ' : letter;
  }
  std::size_t length = 1000;
  if (text.size() <= length)
  {
    return text;
  }
  while (length > 0 && IsContinuation(text[length]))
  {
    --length;
  }
  return text.substr(0, length) + "...";
}

}
