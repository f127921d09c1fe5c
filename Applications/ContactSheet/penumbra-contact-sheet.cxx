// Lays out pictures as one contact sheet. Exit status: 0 done, 1 the sheet could not be made, 2 bad
// input or usage; errors are one line on stderr.

#include "InputError.h"
#include "SheetCommand.h"
#include "vtkMessageCollector.h"

#include <vtkNew.h>

#include <exception>
#include <iostream>
#include <new>

namespace
{
enum ExitStatus
{
  Done = 0,
  Failed = 1,
  BadInput = 2
};

ExitStatus Fail(ExitStatus status, std::string message)
{
  for (char& letter : message)
  {
    if (static_cast<unsigned char>(letter) < ' ')
    {
      letter = ' ';
    }
  }
  std::cerr << "penumbra-contact-sheet: " << message << std::endl;
  return status;
}
}

int main(int argc, char* argv[])
{
  vtkNew<vtkMessageCollector> messages;
  messages->Install();
  try
  {
    penumbra::RunSheetCommand(argc, argv);
    return Done;
  }
  catch (const penumbra::InputError& error)
  {
    return Fail(BadInput, error.what());
  }
  catch (const std::bad_alloc&)
  {
    return Fail(Failed, "out of memory");
  }
  catch (const std::exception& error)
  {
    return Fail(Failed, error.what());
  }
}
