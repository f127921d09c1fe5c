#include "ProgressLine.h"

#include "Process.h"

#include <iostream>

namespace penumbra
{

ProgressLine::ProgressLine(const std::string& what)
  : What(what)
  , IsShown(IsTerminalAtStandardError())
{
  if (this->IsShown)
  {
    std::cerr << this->What << std::flush;
  }
}

ProgressLine::~ProgressLine()
{
  if (this->IsShown)
  {
    std::cerr << std::endl;
  }
}

void ProgressLine::Tell(double part)
{
  const int percent = static_cast<int>(100.0 * part);
  if (this->IsShown && percent != this->Percent)
  {
    this->Percent = percent;
    std::cerr << "\r" << this->What << ": " << percent << " %" << std::flush;
  }
}

}
