#include "vtkMessageCollector.h"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <regex>

vtkStandardNewMacro(vtkMessageCollector);

namespace
{
// A shader that does not compile comes with all of its source.
constexpr std::size_t LongestMessage = 400;

std::string InOneLine(const std::string& text)
{
  static const std::regex place("^(ERROR|Warning|Generic Warning|Debug): In [^\n]*, line \\d+\n");
  static const std::regex object("^[A-Za-z0-9_]+ \\((0x)?[0-9A-Fa-f]+\\): ");
  std::string line = std::regex_replace(text.substr(0, 4 * LongestMessage), place, "");
  line = std::regex_replace(line, object, "");
  line = std::regex_replace(line, std::regex("\\s+"), " ");
  line = line.substr(0, line.find_last_not_of(' ') + 1);
  return line.size() > LongestMessage ? line.substr(0, LongestMessage) + "..." : line;
}

void AddOnce(std::vector<std::string>& messages, const std::string& message)
{
  if (std::find(messages.begin(), messages.end(), message) == messages.end())
  {
    messages.push_back(message);
  }
}
}

//------------------------------------------------------------------------------
vtkMessageCollector::vtkMessageCollector() = default;

//------------------------------------------------------------------------------
vtkMessageCollector::~vtkMessageCollector() = default;

//------------------------------------------------------------------------------
void vtkMessageCollector::Install()
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkOutputWindow::SetInstance(this);
}

//------------------------------------------------------------------------------
void vtkMessageCollector::DisplayText(const char* text)
{
  AddOnce(this->Warnings, InOneLine(text));
}

//------------------------------------------------------------------------------
void vtkMessageCollector::DisplayErrorText(const char* text)
{
  AddOnce(this->Errors, InOneLine(text));
}

//------------------------------------------------------------------------------
void vtkMessageCollector::DisplayWarningText(const char* text)
{
  AddOnce(this->Warnings, InOneLine(text));
}

//------------------------------------------------------------------------------
void vtkMessageCollector::DisplayGenericWarningText(const char* text)
{
  AddOnce(this->Warnings, InOneLine(text));
}

//------------------------------------------------------------------------------
void vtkMessageCollector::DisplayDebugText(const char*) {}

//------------------------------------------------------------------------------
void vtkMessageCollector::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Errors: " << this->Errors.size() << "\n";
  os << indent << "Warnings: " << this->Warnings.size() << "\n";
}
