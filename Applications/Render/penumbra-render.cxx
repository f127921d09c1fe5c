// Renders a scene or a volume to a picture. Exit status: 0 done, 1 rendering failed, 2 bad input or
// usage; errors are one line on stderr.

#include "ProgramMain.h"
#include "RenderCommand.h"

int main(int argc, char* argv[])
{
  return penumbra::RunMain("penumbra-render",
    [argc, argv](vtkMessageCollector* messages)
    {
      if (const auto command = penumbra::ParseCommandLine(argc, argv))
      {
        penumbra::Execute(*command, messages);
      }
    });
}
