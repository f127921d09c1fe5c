/**
 * @file    StudyCommand.h
 * @brief   penumbra-study from its command line to its files
 */

#ifndef StudyCommand_h
#define StudyCommand_h

namespace penumbra
{

/**
 * Runs the study that the arguments name and writes its files, or prints what they ask for. What an
 * interrupted study left is taken up.
 * @throw InputError where the arguments are not valid, std::runtime_error where a study fails or
 * misses a bound.
 */
void RunStudyCommand(int argc, char* argv[]);

}

#endif
