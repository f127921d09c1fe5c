#include "ProgramMain.h"

#include "InputError.h"
#include "vtkMessageCollector.h"

#include <vtkNew.h>

#include <exception>
#include <iostream>
#include <new>
#include <string>

namespace penumbra
{
namespace
{
enum ExitStatus
{
  Done = 0,
  Failed = 1,
  BadInput = 2
};

int Fail(const char* program, ExitStatus status, std::string message)
{
  for (char& letter : message)
  {
    if (static_cast<unsigned char>(letter) < ' ')
    {
      letter = ' ';
    }
  }
  std::cerr << program << ": " << message << std::endl;
  return status;
}
}

//------------------------------------------------------------------------------
int RunMain(const char* program, const std::function<void(vtkMessageCollector*)>& task)
{
  vtkNew<vtkMessageCollector> messages;
  messages->Install();
  try
  {
    task(messages);
    return Done;
  }
  catch (const InputError& error)
  {
    return Fail(program, BadInput, error.what());
  }
  catch (const std::bad_alloc&)
  {
    return Fail(program, Failed, "out of memory");
  }
  catch (const std::exception& error)
  {
    return Fail(program, Failed, error.what());
  }
}

}
