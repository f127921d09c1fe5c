// Renders a scene or a volume to a picture. Exit status: 0 done, 1 rendering failed, 2 bad input or
// usage; errors are one line on stderr.

#include "InputError.h"
#include "RenderCommand.h"
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
  RenderingFailed = 1,
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
  std::cerr << "penumbra-render: " << message << std::endl;
  return status;
}
}

int main(int argc, char* argv[])
{
  vtkNew<vtkMessageCollector> messages;
  messages->Install();
  try
  {
    const auto command = penumbra::ParseCommandLine(argc, argv);
    if (command)
    {
      penumbra::Execute(*command, messages);
    }
    return Done;
  }
  catch (const penumbra::InputError& error)
  {
    return Fail(BadInput, error.what());
  }
  catch (const std::bad_alloc&)
  {
    return Fail(RenderingFailed, "out of memory");
  }
  catch (const std::exception& error)
  {
    return Fail(RenderingFailed, error.what());
  }
}
