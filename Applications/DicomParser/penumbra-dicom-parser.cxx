// Parses DICOM files for the other programs: what a malformed file ends is this process, not
// theirs.

#include "DicomParserProgram.h"

int main(int argc, char* argv[])
{
  return penumbra::RunDicomParser(argc, argv);
}
