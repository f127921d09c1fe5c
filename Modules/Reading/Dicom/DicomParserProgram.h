/**
 * @file    DicomParserProgram.h
 * @brief   the program that parses DICOM files for another process
 */

#ifndef DicomParserProgram_h
#define DicomParserProgram_h

#include "PenumbraReadingModule.h" // For export macro

namespace penumbra
{

/**
 * All of penumbra-dicom-parser but its main function: answers requests from stdin on stdout until
 * there are no more, and puts voxels into the memory that it shares with the process that started
 * it. Returns the exit status.
 */
PENUMBRAREADING_EXPORT int RunDicomParser(int argc, char* argv[]);

}

#endif
