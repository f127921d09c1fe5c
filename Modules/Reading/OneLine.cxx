#include "OneLine.h"

namespace penumbra
{

std::string OneLine(std::string text)
{
  for (char& letter : text)
  {
    const auto code = static_cast<unsigned char>(letter);
    letter = code < ' ' || code == 127 ? ' ' : letter;
  }
  constexpr std::size_t longest = 1000;
  return text.size() > longest ? text.substr(0, longest) + "..." : text;
}

}
