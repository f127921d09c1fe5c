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
 * All of penumbra-dicom-parser but its main function: answers the request in the shared memory that
 * the first argument names, on stdout. Returns the exit status.
 */
PENUMBRAREADING_EXPORT int RunDicomParser(int argc, char* argv[]);

}

#endif
