/**
 * @file    SheetCommand.h
 * @brief   penumbra-contact-sheet from its command line to its file
 */

#ifndef SheetCommand_h
#define SheetCommand_h

namespace penumbra
{

/**
 * Lays out the sheet that the arguments name, or prints what they ask for. The file appears only if
 * all went well.
 * @throw InputError where the arguments or what they name are not valid, RenderingError where the
 * file cannot be written.
 */
void RunSheetCommand(int argc, char* argv[]);

}

#endif
