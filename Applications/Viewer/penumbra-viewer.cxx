// Shows a scene or a volume in a window. Exit status: 0 done, 1 rendering failed, 2 bad input or
// usage; errors are one line on stderr.

#include "ProgramMain.h"
#include "ViewerCommand.h"
#include "ViewerProgram.h"

int main(int argc, char* argv[])
{
  return penumbra::RunMain("penumbra-viewer",
    [argc, argv](vtkMessageCollector* messages)
    {
      if (const auto command = penumbra::ParseViewerCommand(argc, argv))
      {
        penumbra::RunViewer(*command, argc, argv, messages);
      }
    });
}
