// Measures error against run time, and what comes out in extreme cases. Exit status: 0 done and
// within the bounds, 1 a bound was missed or a study failed, 2 bad input or usage; errors are one
// line on stderr.

#include "ProgramMain.h"
#include "StudyCommand.h"

int main(int argc, char* argv[])
{
  return penumbra::RunMain("penumbra-study",
    [argc, argv](vtkMessageCollector*) { penumbra::RunStudyCommand(argc, argv); });
}
