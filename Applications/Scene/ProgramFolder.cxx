#include "ProgramFolder.h"

#include <vtksys/SystemTools.hxx>

#include <string>

namespace penumbra
{

std::filesystem::path FolderOfProgram(const char* argument)
{
  std::error_code error;
  // Where there is such a link, it is right even if the argument is not.
  std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  std::string found;
  std::string message;
  if (error && vtksys::SystemTools::FindProgramPath(argument, found, message))
  {
    program = std::filesystem::weakly_canonical(std::filesystem::u8path(found), error);
  }
  return program.parent_path();
}

}
