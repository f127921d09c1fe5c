#include "NumberText.h"

#include <locale>
#include <sstream>

namespace penumbra
{

std::string NumberText(double number)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << number;
  return text.str();
}

std::string CountText(std::size_t count, const std::string& what)
{
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}
