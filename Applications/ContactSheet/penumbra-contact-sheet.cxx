// Lays out pictures as one contact sheet. Exit status: 0 done, 1 the sheet could not be made, 2 bad
// input or usage; errors are one line on stderr.

#include "ProgramMain.h"
#include "SheetCommand.h"

int main(int argc, char* argv[])
{
  return penumbra::RunMain("penumbra-contact-sheet",
    [argc, argv](vtkMessageCollector*) { penumbra::RunSheetCommand(argc, argv); });
}
